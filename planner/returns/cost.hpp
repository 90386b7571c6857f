#pragma once

#include "planner/returns/limits.hpp"
#include "planner/returns/problem.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace furrow::planner {

/// What a heuristic compares: the non-spray time, and by how much the sorties outlast tank or pack.
struct JudgedReturns {
  double non_spray_s;  ///< The same as of `evaluated`, to the last bit.
  double excess_s;     ///< Over all sorties, spraying beyond the tank and flight beyond the pack;
                       ///< zero if and only if the returns are feasible.
};

/// The costs of `evaluated` without the plan: for searches that judge millions of choices.
class ReturnCost {
 public:
  explicit ReturnCost(const ReturnProblem& problem);

  /// @param returns  Rising, below the last cell.
  /// Time O(returns), no allocation.
  JudgedReturns operator()(std::span<const std::uint32_t> returns) const;

  /// Last cell that one tank sprays from cell i.
  std::uint32_t tank_reach(std::uint32_t i) const { return tank_reach_[i]; }
  /// Last cell up to which one tank and one pack carry a sortie from cell i; i if there is none.
  std::uint32_t reach(std::uint32_t i) const { return reach_[i]; }
  bool carries(std::uint32_t first, std::uint32_t last) const {
    return last <= tank_reach_[first] && flight_s(first, last) <= limits_.pack_s;
  }

  std::uint32_t last_cell() const { return static_cast<std::uint32_t>(cells_.size() - 1); }
  const Limits& limits() const { return limits_; }

  /// What a sortie from cell `first` to cell `last` takes of a pack, seconds of level flight.
  double flight_s(std::uint32_t first, std::uint32_t last) const {
    return cells_[first].out_s + (cells_[last].route_s - cells_[first].resume_s) +
           cells_[last].home_s;
  }
  /// In the bay before a sortie that sprays `spray_m`, seconds.
  double service_s(double spray_m, bool swap) const {
    const double fill = spray_m <= 0.0 ? 0.0 : fill_base_s_ + spray_m / range_m_ * fill_rise_s_;
    return swap && swap_s_ > fill ? swap_s_ : fill;
  }
  /// Way home from stop i, seconds.
  double back_s(std::uint32_t i) const { return cells_[i].back_s; }
  /// Way out to resume i, less the ferry between strips that it replaces, seconds. i > 0.
  double leave_s(std::uint32_t i) const { return cells_[i].leave_s; }
  double spray_m(std::uint32_t first, std::uint32_t last) const {
    return cells_[last].spray_m - cells_[first].resume_m;
  }

 private:
  struct Cell {
    double spray_m, back_s, resume_m, leave_s;
    double route_s, resume_s, out_s, home_s;  // of a pack
  };
  std::vector<Cell> cells_;
  std::vector<std::uint32_t> tank_reach_, reach_;
  Limits limits_;
  double spray_mps_, range_m_;
  double swap_s_, fill_base_s_, fill_rise_s_;
};

}  // namespace furrow::planner
