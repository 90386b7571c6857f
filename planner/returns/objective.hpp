#pragma once

#include "planner/returns/cost.hpp"
#include "planner/returns/solve.hpp"

#include <cstdint>
#include <span>

namespace furrow::planner {

/// Seconds that a choice of returns costs: non-spray time plus extra cost. Counts its calls.
class ReturnObjective {
 public:
  /// Keeps references to both arguments.
  ReturnObjective(const ReturnProblem& problem, const ExtraCost& extra);

  /// Infeasible returns cost their excess and a step besides, but no extra cost: nobody knows how a
  /// plan that cannot be flown would queue. Compare them with feasible ones by `is_feasible` first.
  /// @param returns  Strictly rising, below the last cell.
  double operator()(std::span<const std::uint32_t> returns);

  bool is_feasible(std::span<const std::uint32_t> returns) const {
    return cost_(returns).excess_s <= 0.0;
  }
  bool has_extra() const { return static_cast<bool>(extra_); }
  const ReturnCost& cost() const { return cost_; }
  std::uint64_t evaluations() const { return evaluations_; }

 private:
  const ReturnProblem& problem_;
  const ExtraCost& extra_;
  ReturnCost cost_;
  double infeasible_s_;
  std::uint64_t evaluations_ = 0;
};

}  // namespace furrow::planner
