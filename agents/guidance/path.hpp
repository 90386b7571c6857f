#pragma once
// The curve an aircraft is to fly: straight legs between waypoints, joined by flyable arcs.

#include "agents/xy.hpp"
#include "core/corner.hpp"

#include <cstddef>
#include <vector>

namespace furrow::agents {

/// What bounds a path's speed and its corners.
struct PathLimits {
  double acceleration_mps2;  ///< Along the path; nine tenths of it across in arcs; > 0.
  double corner_cut_m;       ///< An arc leaves its legs at most this far from the corner.
  double min_radius_m;       ///< No arc is tighter; a corner that would be is turned at a stop.
};

/// A stretch of constant curvature.
struct Segment {
  double start_m, length_m;  ///< Along the path.
  Xy from, ahead;            ///< Where it begins, and the unit vector in which.
  double curvature_per_m;    ///< Right turns positive; 0 on a straight line.
  double limit_mps;          ///< Speed within.
  double entry_mps;          ///< Speed at its beginning from which all that follows can be kept.

  double end_m() const { return start_m + length_m; }
  bool is_straight() const { return curvature_per_m == 0.0; }
  friend bool operator==(const Segment&, const Segment&) = default;
};

class Path {
 public:
  /// Starts at rest at `start_m`.
  Path(Xy start_m, PathLimits limits);

  /// Appends a straight leg to `to_m`, flown at `limit_mps` at most. A leg of no length is left
  /// out.
  /// @param corner  How the path may turn at `to_m`.
  /// @return  Distance along the legs, corners uncut, from the start to `to_m` [m].
  double add(Xy to_m, double limit_mps, Corner corner = Corner::cut);

  /// Cuts the corners, plans the speeds, ends at rest. Once, before anything below is asked.
  void finish();

  const std::vector<Segment>& segments() const { return segments_; }
  double length_m() const { return length_; }

  /// The distance along the smoothed path of a point `leg_m` along the legs: a corner is its arc's
  /// middle.
  double along_m(double leg_m) const;

  /// Time to fly it without wind [s].
  double duration_s() const;

 private:
  struct Vertex {
    Xy at;
    double leg_m;      // along the legs, uncut
    double limit_mps;  // of the leg that ends here
    Corner corner = Corner::cut;
    double cut_m = 0.0, arc_start_m = 0.0, arc_length_m = 0.0;
  };

  double turn(std::size_t corner) const;
  void cut_corners();
  void append(const Segment& segment);
  void plan_speeds();

  PathLimits limits_;
  std::vector<Vertex> vertices_;
  std::vector<Segment> segments_;
  double length_ = 0.0;
};

/// Where a point of a segment is, and which way the path goes there.
struct Pose {
  Xy at, ahead;
};
Pose pose(const Segment& segment, double along_m);

}  // namespace furrow::agents
