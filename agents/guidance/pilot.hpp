#pragma once

#include "agents/guidance/deviation.hpp"
#include "agents/guidance/pace.hpp"
#include "agents/guidance/path.hpp"

#include <optional>

namespace furrow::agents {

/// Keeps an aircraft on its path: the deviation of the position estimate from the segment being
/// flown drives the correction of velocity, the pace says how fast to go.
class Pilot {
 public:
  /// @param planned_mps2  Acceleration that paths are planned with.
  /// @param limit_mps2    Acceleration that corrections may use, >= planned.
  Pilot(double planned_mps2, double limit_mps2);

  /// Takes over a finished path at its beginning.
  void follow(Path path);

  /// Whether `path` is the one being flown up to here, and all that follows on it can be flown
  /// from the speed at hand.
  bool leads_on(const Path& path) const;

  /// Goes on along a path that leads on, without a stop.
  /// @pre leads_on(path)
  void redirect(Path path);

  /// One control period.
  /// @param stop_m  Where along the path to stop, at the latest.
  /// @return  The acceleration over ground that is wanted [m/s2].
  Xy steer(double stop_m, Xy estimate_m, Xy velocity_mps);

  /// Takes note of where the aircraft is now, at the end of a period.
  void observe(Xy estimate_m);

  const Path& path() const { return path_; }
  const Pace& pace() const { return pace_; }
  const Segment& segment() const { return path_.segments()[pace_.segment()]; }
  Deviation deviation_now() const { return deviation_; }
  Xy ahead() const { return ahead_; }

 private:
  double planned_, limit_;
  Path path_;
  Pace pace_;
  Deviation deviation_{};
  Xy ahead_{0.0, 1.0};
};

}  // namespace furrow::agents
