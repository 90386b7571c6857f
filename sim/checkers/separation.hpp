#pragma once
// How near aircraft came to each other in the air, judged from their true tracks alone.

#include "core/messages.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace furrow::sim {

/// A stretch of time in which two aircraft in the air were nearer than they should be.
struct Encounter {
  std::size_t first, second;  ///< Tracks, first < second.
  Instant from, to;
  double closest_m;
};

struct Separation {
  std::vector<Encounter> encounters;  ///< By time, then tracks.
  std::optional<double> closest_m;    ///< Of all encounters; none without one.
};

/// Tracks are flown straight between their points; two points more than a second and a half apart
/// are a stop on the ground, where nobody is near to anybody. Distances are straight lines, heights
/// included.
///
/// Time O(p log p + n) for p points in one second at a time and n pairs within reach of each other.
///
/// @param tracks      One of each aircraft, rising in time, a point a second at least.
/// @param distance_m  Nearer than this is an encounter; > 0.
Separation separation(const std::vector<std::vector<TrackPoint>>& tracks, double distance_m);

}  // namespace furrow::sim
