#pragma once
// A fleet plan that a search changes step by step.

#include "core/random.hpp"
#include "planner/fleet/problem.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace furrow::planner::fleet {

/// Sorties in the order in which they are flown, and where they lie along the path. They spray the
/// whole path once. Every change keeps that; what no tank carries is refused.
class CutPlan {
 public:
  /// @param sorties  Spray the path from its begin to its end once, in any order; each within its
  ///                 aircraft's tank.
  CutPlan(const FleetProblem& problem, FleetSorties sorties);

  const FleetSorties& sorties() const { return sorties_; }

  /// One change by chance: of a cut, of several cuts together, of who flies what and when, of where
  /// it lands; or a sortie more or less.
  /// @return  False, and nothing is changed, if it drew one that is refused.
  bool change(Random& random);

 private:
  bool shift_cut(Random& random);
  bool shift_cuts(Random& random);
  bool exchange(Random& random);
  bool hand_over(Random& random);
  bool divide(Random& random);
  bool join(Random& random);
  bool land_elsewhere(Random& random);

  Sortie& along(std::size_t k) { return sorties_[by_place_[k]]; }
  double tank_m(const Sortie& s) const { return problem_->fliers[s.flier].tank_m; }
  double drawn_cut_m(Random& random, double low_m, double high_m, double now_m) const;
  std::uint32_t nearest_depot(double at_m) const;
  void take_out(std::size_t flown);
  void put_in(std::size_t flown, std::size_t place, const Sortie& sortie);

  const FleetProblem* problem_;
  FleetSorties sorties_;
  std::vector<std::uint32_t> by_place_;  ///< Along the path, numbers of sorties.
};

/// Whether one tank and one pack carry each sortie.
bool is_carried(const FleetProblem& problem, const FleetSorties& sorties);

}  // namespace furrow::planner::fleet
