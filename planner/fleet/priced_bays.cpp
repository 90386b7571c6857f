#include "planner/fleet/priced_bays.hpp"

#include <algorithm>

namespace furrow::planner::fleet {

/// What a flight sprays at most if so many slots, and a part of one, went to filling before it.
double PricedAircraft::tanks(std::size_t level, std::size_t filled) const {
  const double most = prices_.sprayed[level - 1];
  if (time_.whole_fill <= 0.0) return most;
  return std::min(most, static_cast<double>(filled + 1) / time_.whole_fill);
}

void PricedAircraft::tabulate_flights() {
  const auto most_filled = static_cast<std::size_t>(time_.whole_fill);
  best_flights_.assign(most_filled + 1, {});
  for (std::size_t filled = 0; filled <= most_filled; ++filled) {
    std::vector<Flight>& best = best_flights_[filled];
    best.assign(time_.slots + 2, {});
    for (std::size_t level = 1; level < best.size(); ++level) {
      best[level] = best[level - 1];
      if (level > prices_.flights.size()) continue;
      const double earns = prices_.flights[level - 1] + prices_.tank * tanks(level, filled);
      if (earns > best[level].earns) best[level] = {earns, level};
    }
  }
}

void PricedAircraft::improve(Choice& best, std::size_t ready, std::size_t filled,
                             double paid) const {
  const std::size_t n = time_.slots;
  const std::vector<Flight>& flights = best_flights_[filled];
  for (std::size_t at = ready; at + time_.service <= n; ++at) {
    const Flight& flight = flights[at - ready + 1];
    const double most = flight.earns - paid + from_[at].most;
    if (most > best.most) best = {most, flight.level, filled, at};
  }
  const Flight& last = flights[n - ready];
  if (last.earns - paid > best.most) best = {last.earns - paid, last.level, filled, none};
}

double PricedAircraft::most(const Slots& time, const Prices& prices) {
  const std::size_t n = time.slots;
  time_ = time;
  prices_ = prices;
  tabulate_flights();
  bays_until_.assign(1, 0.0);
  for (const double price : prices.bays) bays_until_.push_back(bays_until_.back() + price);
  from_.assign(n + 1, {});
  for (std::size_t at = n + 1; at-- > 0;) {
    for (std::size_t filled = 0; filled < best_flights_.size(); ++filled) {
      const std::size_t ready = at + time.service + filled;
      if (ready > n) break;
      improve(from_[at], ready, filled, bays_until_[ready] - bays_until_[at]);
    }
  }
  first_ = {};
  improve(first_, 0, best_flights_.size() - 1, 0.0);
  return first_.most;
}

Earned PricedAircraft::earned() const {
  Earned all{.flights = std::vector<double>(prices_.flights.size(), 0.0),
             .bays = std::vector<double>(time_.slots, 0.0)};
  const auto fly = [&](const Choice& choice) {
    if (choice.level == 0) return;
    all.flights[choice.level - 1] += 1.0;
    all.tanks += tanks(choice.level, choice.filled);
  };
  fly(first_);
  for (std::size_t at = first_.next; at != none; at = from_[at].next) {
    const Choice& choice = from_[at];
    fly(choice);
    if (choice.most <= 0.0) break;
    const std::size_t ready = at + time_.service + choice.filled;
    for (std::size_t slot = at; slot < ready; ++slot) all.bays[slot] += 1.0;
  }
  return all;
}

}  // namespace furrow::planner::fleet
