#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace furrow::planner::fleet {

/// Time up to a makespan in slots, in which a service without filling takes a whole number of them.
struct Slots {
  std::size_t slots;        ///< Until the makespan.
  std::size_t service;      ///< Of one service, >= 1.
  double whole_fill = 0.0;  ///< Filling a whole tank takes so many besides, >= 0.
};

/// Prices of what aircraft do.
struct Prices {
  std::span<const double> flights;  ///< Of a flight of up to 1, 2, ... slots, >= 0; the last for
                                    ///< all longer.
  std::span<const double> sprayed;  ///< By the same: tanks that it can spray at most, rising.
  double tank;                      ///< Of spraying a tank, >= 0.
  std::span<const double> bays;     ///< Of a bay, by the slot, of any sign.
};

/// What the most is earned by.
struct Earned {
  std::vector<double> flights{};  ///< How many of each.
  std::vector<double> bays{};     ///< Slots in them, by the slot.
  double tanks = 0.0;             ///< Sprayed.
};

/// What one aircraft can earn by flights and by spraying, less what its time in bays costs: the
/// services before all flights but the first, and filling what the next flight sprays.
class PricedAircraft {
 public:
  /// The most, over all ways to divide the time; flying nothing earns nothing. Flights and services
  /// begin anywhere within slots, so a flight between two of them may take one slot more than they
  /// are apart, and what is filled may take one slot more than is paid for.
  /// Time O(slots^2 (1 + slots of filling)).
  double most(const Slots& time, const Prices& prices);

  /// By what.
  Earned earned() const;

 private:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  /// What is best from one slot on, where a service begins there.
  struct Choice {
    double most = 0.0;
    std::size_t level = 0;    ///< Of the flight after it; 0: none.
    std::size_t filled = 0;   ///< Slots of filling before.
    std::size_t next = none;  ///< Slot in which the service after that begins.
  };
  /// The flight that earns the most, of those that are not longer.
  struct Flight {
    double earns = 0.0;
    std::size_t level = 0;
  };
  double tanks(std::size_t level, std::size_t filled) const;
  void tabulate_flights();
  void improve(Choice& best, std::size_t ready, std::size_t filled, double paid) const;

  Slots time_{};
  Prices prices_{};
  std::vector<std::vector<Flight>> best_flights_{};  ///< By slots of filling, and by those of time.
  std::vector<double> bays_until_{};                 ///< Prices of all slots before.
  std::vector<Choice> from_{};
  Choice first_{};
};

}  // namespace furrow::planner::fleet
