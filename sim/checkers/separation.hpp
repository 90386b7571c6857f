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

/// Where an aircraft was in the air.
struct AirTrack {
  std::vector<TrackPoint> points;  ///< Rising in time, a point a second at least in the air.
  std::vector<Instant> landings;   ///< Rising: it stands from then to its next point.
};

struct Separation {
  std::vector<Encounter> encounters;  ///< By time, then tracks.
  std::optional<double> closest_m;    ///< Of all encounters; none without one.
};

/// Tracks are flown straight between their points, but for stops on the ground, however short:
/// there nobody is near to anybody. Distances are straight lines, heights included.
///
/// Time O(p log p + n) for p points in one second at a time and n pairs within reach of each other.
///
/// @param tracks      One of each aircraft.
/// @param distance_m  Nearer than this is an encounter; > 0.
Separation separation(const std::vector<AirTrack>& tracks, double distance_m);

}  // namespace furrow::sim
