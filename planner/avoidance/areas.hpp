#pragma once
// Missed and repeated ground from footprints: fast in a window for the search, by GEOS for the
// record.

#include "planner/avoidance/room.hpp"
#include "planner/coverage/plane.hpp"

#include <vector>

namespace furrow::planner {

/// A way flown with the valve open, widened to half its width on each side.
struct FootprintM {
  PathM path;  ///< At least two places; bends in steps of at most a few degrees.
  double half_m;
};

struct WrongArea {
  double missed_m2;    ///< Of what straight passes cover, outside obstacles, and nothing sprays.
  double repeated_m2;  ///< Sprayed again, counted each further time.
  double sum_m2() const { return missed_m2 + repeated_m2; }
};

/// What happens around one crowd: everything is measured from `low_m` to `high_m` along the pass.
struct WindowM {
  PointM origin;
  RowFrame frame;  ///< +x along the pass.
  double low_m, high_m;
};

/// Wrong area within `window`: widths are measured exactly on lines across the pass, a quarter of a
/// metre apart. Ground that one footprint passes twice counts once.
WrongArea area_in(const WindowM& window, const std::vector<FootprintM>& straight,
                  const std::vector<CircleM>& circles, const std::vector<FootprintM>& flown,
                  const std::vector<RingM>& rings = {});

/// Wrong area of everything, from the union of footprints.
WrongArea area_of(const std::vector<FootprintM>& straight, const std::vector<CircleM>& circles,
                  const std::vector<FootprintM>& flown, const std::vector<RingM>& rings = {});

/// What footprints spray again, counted each further time.
double repeated_m2(const std::vector<FootprintM>& flown);

/// Repeated by the inner end of a boom half as wide as `half_m` that runs backwards in turns
/// tighter than itself: (half - r)^2 / 2 for each radian turned.
double backswept_m2(double turn_rad, double radius_m, double half_m);

}  // namespace furrow::planner
