#pragma once
// Which planner looks for ways in the air, and for how long.

#include "mission/reader.hpp"
#include "planner/routes/plan_route.hpp"

#include <optional>
#include <string>

namespace furrow::mission {

/// Keys `planner` and `evaluations`; `otherwise` where they are left out.
/// @param most  Evaluations that may be asked for.
/// @param none  A name for no search at all, if there may be none.
std::optional<planner::RouteSettings> read_search(const Section& s,
                                                  const planner::RouteSettings& otherwise,
                                                  std::uint32_t most,
                                                  const std::optional<std::string>& none = {});

}  // namespace furrow::mission
