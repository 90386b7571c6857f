#include "planner/returns/refine.hpp"

#include "planner/returns/window_search.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

namespace furrow::planner {
namespace {

// From half a tank either way, coarsely, down to every cell nearby. `tank` in cells.
std::array<Windows, 4> scales(std::uint32_t tank) {
  const auto part = [tank](std::uint32_t n) { return std::max(tank / n, 1u); };
  return {{{.stride = part(128), .half_width = part(2)},
           {.stride = part(256), .half_width = part(4)},
           {.stride = part(640), .half_width = part(24)},
           {.stride = 1, .half_width = part(50)}}};
}

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr std::uint32_t most_rounds = 12;
constexpr std::array<std::int64_t, 9> shifts = {1, 2, 3, 5, 10, 25, 50, 100, 250};

class Refinement {
 public:
  Refinement(const ReturnProblem& problem, const Returns& start, ReturnObjective& objective,
             std::uint64_t moves)
      : objective_{objective},
        free_{battery_free(legs_of(problem))},
        best_{.returns = start, .objective_s = objective(start)},
        feasible_{objective.is_feasible(start)},
        moves_left_{moves} {
    for (const std::uint32_t first : problem.strip_starts) {
      if (first > 0) strip_ends_.push_back(first - 1);
      strip_ends_.push_back(first);
    }
  }

  FoundReturns run() {
    for (std::uint32_t round = 0; round < most_rounds; ++round) {
      const double before_s = best_.objective_s;
      for (const Windows scale : scales(objective_.cost().tank_reach(0))) search(scale);
      while (shift_or_drop()) {
      }
      if (best_.objective_s == before_s) break;
    }
    return best_;
  }

 private:
  // Anything feasible is better than anything that is not, whatever the extra cost of the former.
  bool accept(const Returns& returns) {
    const bool feasible = objective_.is_feasible(returns);
    if (feasible_ && !feasible) return false;
    const double value_s = objective_(returns);
    // Less than a nanosecond is rounding, and could go on for ever.
    if (feasible == feasible_ && value_s >= best_.objective_s - 1e-9) return false;
    best_ = {.returns = returns, .objective_s = value_s};
    feasible_ = feasible;
    return true;
  }

  void search(Windows windows) {
    const ReturnCost& cost = objective_.cost();
    for (std::uint32_t round = 0; round < most_rounds; ++round) {
      const auto candidates = cells_in(windows, best_.returns, strip_ends_, cost.last_cell());
      const double cutoff_s = feasible_ ? cost(best_.returns).non_spray_s : infinite;
      const Returns found = best_among(cost, free_, candidates, cutoff_s);
      if (found.empty() || !accept(found)) return;
    }
  }

  // Whether some move helped; takes the first that does for each group of returns.
  bool shift_or_drop() {
    bool helped = false;
    for (std::size_t n = 0; n < best_.returns.size(); ++n) {
      for (std::size_t group = 1; group <= 3 && n + group <= best_.returns.size(); ++group) {
        for (const std::int64_t shift : shifts) {
          helped |= try_shift(n, group, shift) || try_shift(n, group, -shift);
        }
      }
    }
    for (std::size_t n = 0; n < best_.returns.size(); ++n) helped |= try_drop(n);
    return helped && moves_left_ > 0;
  }

  bool try_shift(std::size_t n, std::size_t group, std::int64_t shift) {
    const Returns& r = best_.returns;
    const std::int64_t before = n == 0 ? 0 : r[n - 1];
    const std::int64_t after = n + group == r.size() ? objective_.cost().last_cell() : r[n + group];
    if (r[n] + shift <= before || r[n + group - 1] + shift >= after || !take_move()) return false;
    Returns moved = r;
    for (std::size_t k = n; k < n + group; ++k) {
      moved[k] = static_cast<std::uint32_t>(moved[k] + shift);
    }
    return accept(moved);
  }

  bool try_drop(std::size_t n) {
    if (!take_move()) return false;
    Returns fewer = best_.returns;
    fewer.erase(fewer.begin() + static_cast<long>(n));
    return accept(fewer);
  }

  bool take_move() {
    if (moves_left_ == 0) return false;
    --moves_left_;
    return true;
  }

  ReturnObjective& objective_;
  BatteryFree free_;
  FoundReturns best_;
  bool feasible_;
  std::vector<std::uint32_t> strip_ends_;
  std::uint64_t moves_left_;
};

}  // namespace

FoundReturns refined(const ReturnProblem& problem, const Returns& start, ReturnObjective& objective,
                     std::uint64_t moves) {
  return Refinement{problem, start, objective, moves}.run();
}

}  // namespace furrow::planner
