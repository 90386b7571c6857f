#pragma once
// Missed and repeated ground from footprints: fast in a window for the search, exact for the
// record.

#include "planner/avoidance/room.hpp"
#include "planner/coverage/plane.hpp"

#include <cstddef>
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

/// The lines x = const that a window is measured on.
struct WindowLines {
  double first_m, step_m;
  std::size_t count;
};

/// Where something begins or ends to lie on a line of a window.
struct AreaMark {
  std::size_t line;
  double place_m;
  std::size_t layer;
  int step;  ///< 1 or -1.
  friend bool operator==(const AreaMark&, const AreaMark&) = default;
};
using AreaMarks = std::vector<AreaMark>;

/// Wrong area within a window for one choice of ways after another: widths are measured exactly on
/// lines across the pass, a quarter of a metre apart.
class AreaWindow {
 public:
  AreaWindow(const WindowM& window, const std::vector<FootprintM>& straight,
             const std::vector<CircleM>& circles, const std::vector<RingM>& rings);

  /// Footprints on the lines. Ground that one of them passes twice counts once.
  AreaMarks sprayed(const std::vector<FootprintM>& footprints) const;

  /// @param sprayed  All that is, as `sprayed` marks it.
  WrongArea wrong(const std::vector<const AreaMarks*>& sprayed) const;

 private:
  WindowM window_;
  WindowLines lines_{};
  AreaMarks still_{};  ///< What is planned and excluded, by line.
};

/// Wrong area within `window`, once.
WrongArea area_in(const WindowM& window, const std::vector<FootprintM>& straight,
                  const std::vector<CircleM>& circles, const std::vector<FootprintM>& sprayed,
                  const std::vector<RingM>& rings = {});

/// Wrong area of everything, from footprints with round corners, measured exactly; repeated beyond
/// what straight passes repeat.
WrongArea area_of(const std::vector<FootprintM>& straight, const std::vector<CircleM>& circles,
                  const std::vector<FootprintM>& sprayed, const std::vector<RingM>& rings = {});

/// Repeated by the inner end of a boom half as wide as `half_m` that runs backwards in turns
/// tighter than itself: (half - r)^2 / 2 for each radian turned.
double backswept_m2(double turn_rad, double radius_m, double half_m);

}  // namespace furrow::planner
