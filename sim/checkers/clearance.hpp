#pragma once
// How near aircraft came to obstacles, judged from their true tracks alone.

#include "sim/checkers/laws.hpp"

#include <optional>
#include <string>
#include <vector>

namespace furrow::sim {

/// Where an aircraft was nearest to an obstacle.
struct Clearance {
  AgentId agent;
  std::string obstacle;
  Length away;  ///< Of its edge; negative inside.
  Instant at;
};

/// The nearest that any flown track came to any obstacle that was there, but for what L22 excuses.
/// @return  Nothing where the plan keeps no safety distance, or nobody has flown.
std::optional<Clearance> least_clearance(const Facts& facts, const std::vector<Envelope>& log);

}  // namespace furrow::sim
