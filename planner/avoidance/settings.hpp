#pragma once

#include "core/units.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace furrow::planner {

/// That ways around obstacles keep beyond the safety distance: aircraft of 10 Hz stray from arcs in
/// wind.
inline constexpr double tracking_room_m = 0.1;

/// What strips are planned to keep, so that `safety` is kept when they are flown.
constexpr Length planned_clearance(Length safety) {
  return safety > Length{} ? safety + metres(tracking_room_m) : Length{};
}

enum class AvoidanceMethod {
  genetic,  ///< Side or split for each crowd by genetic search, per pass and then for all.
  exact,    ///< The same by enumeration; genetic where a group of crowds is too large for it.
  classic,  ///< Half circles on the left, the yardstick; not flyable; outlines as circles.
  split,    ///< The valve always closed on the way around.
};

/// How strips are led around obstacles.
struct AvoidanceSettings {
  AvoidanceMethod method = AvoidanceMethod::genetic;
  Length safety{};     ///< From obstacles, >= 0.
  Length turn_radius;  ///< R_z > 0.
  /// Whether strips are joined by Dubins turns of that radius; otherwise aircraft turn on the spot.
  bool dubins_turns = false;
  double length_weight = 0.5, area_weight = 0.5;    ///< Of fitness, >= 0.
  std::uint32_t population = 60, iterations = 200;  ///< Of the genetic search.
  double target_fitness = 0;                        ///< At which it stops.
  std::uint64_t seed = 0;
  /// Obstacles of the field at which rows end, as they do at holes, by number; rows are led around
  /// all others. `cover` chooses them; none for half circles.
  std::vector<std::size_t> ends_rows{};
};

}  // namespace furrow::planner
