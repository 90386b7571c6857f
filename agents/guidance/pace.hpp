#pragma once

#include "agents/guidance/path.hpp"

#include <cstddef>
#include <limits>

namespace furrow::agents {

/// A stop that is never reached.
inline constexpr double no_stop = std::numeric_limits<double>::infinity();

/// The point that an aircraft chases: it runs along a path as fast as limits, corners and the stop
/// ahead allow, one control period at a time.
class Pace {
 public:
  /// At rest at the beginning of a path.
  explicit Pace(double acceleration_mps2);

  /// One period on, to come to rest no further than `stop_m`.
  /// @param eagerness  Share of the speed limit to use, 0 .. 1: less when the aircraft lags.
  void advance(const Path& path, double stop_m, double eagerness);

  double along_m() const { return along_; }
  double speed_mps() const { return speed_; }
  std::size_t segment() const { return segment_; }
  bool is_at_rest() const { return speed_ == 0.0; }

  /// Distance to a stop from now on.
  double braking_m() const;

 private:
  double next_speed(const Path& path, double stop_m, double eagerness) const;
  double braking_to(double rest_m, double exit_mps) const;

  double limit_;  // of acceleration
  double along_ = 0.0, speed_ = 0.0;
  std::size_t segment_ = 0;
};

}  // namespace furrow::agents
