#include "planner/fleet/priced_bays.hpp"

#include <algorithm>

namespace furrow::planner::fleet {

double PricedAircraft::most(Slots time, std::span<const double> flights,
                            std::span<const double> services, std::span<double> flight_counts,
                            std::span<double> service_counts) {
  const std::size_t n = time.slots, none = n + 1;
  best_flight_.assign(n + 2, 0);
  earned_.assign(n + 2, 0.0);
  for (std::size_t j = 1; j <= n + 1; ++j) {
    const bool better = j <= flights.size() && flights[j - 1] > earned_[j - 1];
    best_flight_[j] = better ? j : best_flight_[j - 1];
    earned_[j] = better ? flights[j - 1] : earned_[j - 1];
  }
  most_.resize(n + 1);
  lands_.resize(n + 1);
  for (std::size_t ready = n + 1; ready-- > 0;) {
    double most = earned_[n - ready];
    std::size_t lands = none;
    for (std::size_t at = ready; at + time.service <= n; ++at) {
      const double value = earned_[at - ready + 1] - services[at] + most_[at + time.service];
      if (value > most) {
        most = value;
        lands = at;
      }
    }
    most_[ready] = most;
    lands_[ready] = lands;
  }
  const auto fly = [&](std::size_t slots) {
    if (best_flight_[slots] > 0) flight_counts[best_flight_[slots] - 1] += 1.0;
  };
  std::fill(flight_counts.begin(), flight_counts.end(), 0.0);
  std::fill(service_counts.begin(), service_counts.end(), 0.0);
  std::size_t ready = 0;
  for (; lands_[ready] != none; ready = lands_[ready] + time.service) {
    fly(lands_[ready] - ready + 1);
    service_counts[lands_[ready]] += 1.0;
  }
  fly(n - ready);
  return most_[0];
}

double PricedBay::most(Slots time, std::span<const double> services, std::span<double> counts) {
  const std::size_t n = time.slots;
  most_.assign(n + 1, 0.0);
  const auto served = [&](std::size_t at) {
    return at + time.service <= n ? services[at] + most_[at + time.service] : 0.0;
  };
  for (std::size_t at = n; at-- > 0;) most_[at] = std::max(most_[at + 1], served(at));
  std::fill(counts.begin(), counts.end(), 0.0);
  for (std::size_t at = 0; at < n;) {
    const bool serves = served(at) > most_[at + 1];
    if (serves) counts[at] += 1.0;
    at += serves ? time.service : 1;
  }
  return most_[0];
}

}  // namespace furrow::planner::fleet
