#pragma once
// All passes of a field with their crowds, priced for the selection.

#include "planner/avoidance/areas.hpp"
#include "planner/avoidance/crowd.hpp"
#include "planner/avoidance/selection.hpp"

#include <optional>
#include <vector>

namespace furrow::planner {

/// A crowd and the pass it lies on.
struct PlacedCrowd {
  std::size_t pass;
  Crowd crowd;
};

class FieldOptions {
 public:
  /// @param turn_m  R_z > 0.
  FieldOptions(std::vector<PassM> passes, const Room& room, double turn_m);

  const std::vector<PassM>& passes() const { return passes_; }
  const std::vector<PlacedCrowd>& crowds() const { return crowds_; }
  std::size_t targets() const { return targets_; }

  /// Costs of every option by itself and of every two that touch the same ground.
  SelectionProblem problem(double length_weight, double area_weight) const;

  /// Pass `pass` as flown with `chosen` options; the valve closed where paths do not meet.
  std::vector<FootprintM> flown(std::size_t pass, const Selection& chosen) const;
  std::vector<FootprintM> straight() const;

  /// Repeated by booms that run backwards in tight turns.
  double backswept_m2(const Selection& chosen) const;

 private:
  struct Window {
    WindowM lines;
    PointM middle;
    double radius_m;                  // around the middle, and
    double aside_m;                   // to each side of the pass, all that the options may change
    std::vector<std::size_t> passes;  // whose footprints may reach into it
    std::optional<AreaWindow> area;
    std::vector<AreaMarks> straight;  // each of these passes
  };
  struct Taken {
    std::size_t crowd, option;
  };
  // A pass with some options taken, in a window.
  struct FlownPass {
    std::size_t pass;
    AreaMarks marks;
  };
  // Of one crowd in its window: no option taken, and each.
  struct Alone {
    double none_m2;
    std::vector<double> wrong_m2;
  };

  Window window_of(std::size_t crowd, const Room& room) const;
  std::vector<FootprintM> footprints(std::size_t pass, const std::vector<Taken>& taken) const;
  FlownPass flown_in(const Window& window, const std::vector<Taken>& taken) const;
  std::vector<FlownPass> options_in(const Window& window, std::size_t crowd) const;
  double wrong_m2(const Window& window, const std::vector<const FlownPass*>& flown) const;
  Alone alone(std::size_t crowd) const;
  bool may_interplay(std::size_t a, std::size_t b) const;
  bool shows_in(const Window& window, const std::vector<FlownPass>& options) const;
  std::optional<Interplay> interplay(std::size_t a, const Alone& a_alone, std::size_t b) const;

  std::vector<PassM> passes_;
  std::vector<PlacedCrowd> crowds_;  // in the order of passes, then along each
  std::vector<Window> windows_;
  std::vector<std::vector<PathM>> around_;  // sampled curves by crowd and option
  std::size_t targets_ = 0;
  double turn_m_;
};

/// What `option` misses and repeats on the first of `passes` while the others fly straight, m2.
double wrong_alone_m2(const std::vector<PassM>& passes, const CrowdOption& option,
                      const Room& room);

}  // namespace furrow::planner
