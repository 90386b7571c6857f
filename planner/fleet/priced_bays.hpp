#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace furrow::planner::fleet {

/// Time up to a makespan in slots, in which a service takes a whole number of them.
struct Slots {
  std::size_t slots;    ///< Until the makespan.
  std::size_t service;  ///< Of one service, >= 1.
};

/// What one aircraft can earn by flights of at most so many slots, less what its services cost.
class PricedAircraft {
 public:
  /// The most, over all ways to divide the time; flying nothing earns nothing. Flights and services
  /// begin anywhere within slots, so a flight between two of them may take one slot more than they
  /// are apart.
  /// @param flights       Price of a flight of up to 1, 2, ... slots, >= 0; the last for all
  /// longer.
  /// @param services      Price of a service by the slot in which it begins.
  /// @param flight_counts, service_counts  What the most is earned by; filled in.
  /// Time O(slots^2).
  double most(Slots time, std::span<const double> flights, std::span<const double> services,
              std::span<double> flight_counts, std::span<double> service_counts);

 private:
  std::vector<std::size_t> best_flight_;  ///< Of at most so many slots; 0: none.
  std::vector<double> earned_, most_;
  std::vector<std::size_t> lands_;  ///< By slot in which it is ready: that of the next service.
};

/// What one bay can earn by services, one after the other.
class PricedBay {
 public:
  /// Time O(slots).
  double most(Slots time, std::span<const double> services, std::span<double> counts);

 private:
  std::vector<double> most_;
};

}  // namespace furrow::planner::fleet
