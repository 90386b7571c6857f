#pragma once

#include "planner/returns/objective.hpp"
#include "planner/returns/problem.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace furrow::planner {

/// Returns as a point of the unit cube: variable n says how much of what the tank and the pack
/// could still carry sortie n sprays. 1 returns when empty; the sorties follow one another, so
/// every point of the cube is a plan and none needs repair for its tank.
///
/// The share is measured in weighted cells: a cell at distance d from the station weighs
/// 1 / sqrt(d), so that the few cells near the station, where good returns lie, take up more room.
/// Where the variables run out, returns follow when empty.
class ShareCode {
 public:
  explicit ShareCode(const ReturnProblem& problem, const ReturnCost& cost);

  /// The returns that a point stands for.
  void decode(std::span<const double> shares, Returns& returns) const;

  /// A point that stands for `returns` as nearly as shares can; `size` variables.
  std::vector<double> encoded(std::span<const std::uint32_t> returns, std::size_t size) const;

 private:
  const ReturnCost& cost_;
  std::vector<double> weight_;  // of all cells up to and including cell i
};

struct GsaReturnsSettings {
  std::uint32_t masses, iterations;  ///< Of one search, masses >= 1.
  std::uint32_t searches;            ///< From independent starts, >= 1.
  std::uint64_t seed;
};

struct FoundReturns {
  Returns returns;
  double objective_s;
};

/// Return points by the gravitational search algorithm over the points of a `ShareCode`: the
/// result of each search, the best first.
///
/// One variable for each return of the simple plan. The number of returns is not fixed: it follows
/// from the shares, from the count of the unplanned plan (all shares 1) upwards. Masses start
/// uniformly at random between half shares and whole ones; in the first search, two of them start
/// at the unplanned and at the simple plan.
///
/// @pre A feasible plan exists, see `infeasibility`.
///
/// Source: Wang et al. 2017, section 2.3, for the objective; the encoding is this project's own.
std::vector<FoundReturns> gsa_returns(const ReturnProblem& problem,
                                      const GsaReturnsSettings& settings,
                                      ReturnObjective& objective);

}  // namespace furrow::planner
