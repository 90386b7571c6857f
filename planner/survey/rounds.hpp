#pragma once
// Who visits which places, in which order.

#include <cstdint>
#include <span>
#include <vector>

namespace furrow::planner {

/// Places and those who visit them, metres and seconds.
struct VisitProblem {
  std::uint32_t places;           ///< >= 1
  std::vector<double> between_m;  ///< From place i to j at i * places + j, the same both ways.
  std::vector<double> back_m;     ///< By place: to where visitors land.
  struct Visitor {
    std::vector<double> out_m;  ///< By place: from where it starts.
    double mps;                 ///< > 0
    double ready_s;             ///< When it starts at the earliest.
  };
  std::vector<Visitor> visitors;  ///< At least one.
};

/// By visitor, the places in the order visited; may be empty.
using Rounds = std::vector<std::vector<std::uint32_t>>;

/// Rounds in which the last place is visited early, and then with early landings in all. A tour is
/// cut into runs, one for each visitor in order, each flown in the direction that ends earlier; the
/// cut is the best there is. Then single places change their round or their place in it, and
/// stretches of rounds are reversed, until nothing helps or 200 000 rounds have been looked at.
/// Packs are not minded.
///
/// Time O(visitors places^2) and that of the search.
///
/// @param tour  Every place once.
Rounds rounds(const VisitProblem& problem, std::span<const std::uint32_t> tour);

}  // namespace furrow::planner
