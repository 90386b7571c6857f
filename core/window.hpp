#pragma once

#include "core/units.hpp"

#include <optional>

namespace furrow {

/// When plans are done within a time window at the latest; none: no end. What they keep of it,
/// flights may take longer than planned.
constexpr std::optional<Seconds> planned_end(Seconds from, std::optional<Seconds> until) {
  constexpr double kept = 0.04;
  if (!until) return std::nullopt;
  return *until - kept * (*until - from);
}

}  // namespace furrow
