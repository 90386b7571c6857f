#pragma once

#include <vector>

namespace furrow::agents {

/// Heights to fly along a path, straight between marks; none over level land.
class HeightProfile {
 public:
  /// @param along_m  Not before the mark before.
  void mark(double along_m, double altitude_m) { marks_.push_back({along_m, altitude_m}); }

  /// From `from_m` at `begins_m` up to a layer and down to 0 at `to_m`, as steeply as `up` and
  /// `down` say [m per m along the path]; lower where the way is too short for the layer.
  void mark_hop(double from_m, double to_m, double begins_m, double layer_m, double up,
                double down);

  bool is_level() const { return marks_.empty(); }

  /// Above the datum; before the first mark and beyond the last as there. 0 over level land.
  double altitude_m(double along_m) const;

  /// All that it rises [m].
  double climb_m() const;

  /// Moves every mark to `place(along_m)`, which does not fall.
  template <class Place>
  void move(Place place) {
    for (Mark& mark : marks_) mark.along_m = place(mark.along_m);
  }

 private:
  struct Mark {
    double along_m, altitude_m;
  };
  std::vector<Mark> marks_{};
};

}  // namespace furrow::agents
