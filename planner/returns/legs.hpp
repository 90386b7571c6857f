#pragma once

#include "planner/returns/problem.hpp"

#include <cstdint>
#include <vector>

namespace furrow::planner {

/// A return problem in plain numbers, cut into legs: one sortie from a return at cell i to the next
/// at cell j > i, and the service before it. For the inner loops of solvers.
///
/// Over hills a pack feels climbs as longer flight; on level land it feels flight as it is.
/// The charge that a pack has given is kept as an offset that does not change while spraying: on
/// landing at cell i, used = offset + landing_s[i]. Whatever cell comes next, leaving i adds
/// trip_s(i) to the offset, or a fresh pack sets it to fresh_offset_s(i). Offsets are never below
/// -route_s[i], for a pack has given at least the way home.
struct Legs {
  std::uint32_t last;           ///< Index of the last cell.
  std::vector<double> spray_m;  ///< As in the problem.
  std::vector<double> route_s;  ///< Flight to stop i, as a pack feels it.
  std::vector<double> back_s;   ///< Way home from stop i.
  std::vector<double> leave_s;  ///< Way out to resume i, less the ferry that it replaces.
  std::vector<double> back_pack_s, leave_pack_s;  ///< The same two, as a pack feels them.
  std::vector<double> landing_s;                  ///< route_s + back_pack_s.
  std::vector<std::uint32_t> reach;               ///< Last cell that one tank sprays from cell i.
  double first_offset_s;                          ///< Offset during the first sortie: its way out.
  double tank_m, pack_s;
  double swap_s, fill_base_s, fill_s_per_m;

  double fill_s(std::uint32_t i, std::uint32_t j) const {
    const double length_m = spray_m[j] - spray_m[i];
    return length_m <= 0.0 ? 0.0 : fill_base_s + fill_s_per_m * length_m;
  }
  double service_s(std::uint32_t i, std::uint32_t j, bool swap) const {
    const double fill = fill_s(i, j);
    return swap && swap_s > fill ? swap_s : fill;
  }
  /// What landing at j adds to the non-spray time: nothing at the very end.
  double arrival_s(std::uint32_t j) const { return j == last ? 0.0 : back_s[j]; }
  /// What a return after cell i takes of a pack; may be negative where it replaces a long ferry.
  double trip_s(std::uint32_t i) const { return back_pack_s[i] + leave_pack_s[i]; }
  double fresh_offset_s(std::uint32_t i) const { return leave_pack_s[i] - route_s[i]; }
};

Legs legs_of(const ReturnProblem& problem);

/// Least non-spray time to land at each cell and from there to the end, were packs inexhaustible
/// and swaps free.
struct BatteryFree {
  std::vector<double> until_s;  ///< Up to landing at cell i; infinite for cell 0.
  std::vector<double> after_s;  ///< From landing at cell i on.
  double optimum_s;             ///< Of the whole problem: a lower bound on every plan.
};

/// Time O(cells), by sliding-window minima.
BatteryFree battery_free(const Legs& legs);

/// A choice of return points that attains `free.optimum_s` were packs inexhaustible.
Returns battery_free_returns(const Legs& legs, const BatteryFree& free);

}  // namespace furrow::planner
