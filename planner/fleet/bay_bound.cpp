#include "planner/fleet/bay_bound.hpp"

#include "planner/fleet/priced_bays.hpp"
#include "planner/fleet/priced_split.hpp"
#include "planner/search/r_algorithm.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace furrow::planner::fleet {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double most_cells = 200'000;
constexpr std::size_t knots = 24;  ///< Of either kind of prices.

/// Values at equal distances, straight in between.
class Ramp {
 public:
  explicit Ramp(std::size_t places)
      : scale_{static_cast<double>(knots - 1) /
               static_cast<double>(std::max<std::size_t>(places - 1, 1))} {}

  double value(std::span<const double> at_knots, std::size_t place) const {
    const auto [k, part] = knot(place);
    return at_knots[k] * (1.0 - part) + at_knots[k + 1] * part;
  }
  void add(std::span<double> to_knots, std::size_t place, double slope) const {
    const auto [k, part] = knot(place);
    to_knots[k] += slope * (1.0 - part);
    to_knots[k + 1] += slope * part;
  }

 private:
  struct Knot {
    std::size_t before;
    double part;
  };
  Knot knot(std::size_t place) const {
    const double at = scale_ * static_cast<double>(place);
    const std::size_t before = std::min(static_cast<std::size_t>(at), knots - 2);
    return {before, at - static_cast<double>(before)};
  }
  double scale_;
};

struct Sizes {
  double service_s, fill_s, aircraft, bays, fastest_mps, tanks;
};

Sizes sizes(const FleetProblem& problem) {
  Sizes s{infinite, infinite, static_cast<double>(problem.fliers.size()), 0.0, 0.0, 0.0};
  double depot_s = infinite, tank_m = 0.0;
  for (const Depot& d : problem.depots) {
    depot_s = std::min(depot_s, d.service_s);
    s.fill_s = std::min(s.fill_s, d.fill_s);
    s.bays += d.bays;
  }
  for (const Flier& f : problem.fliers) {
    s.service_s = std::min(s.service_s, depot_s + f.service_s);
    s.fastest_mps = std::max(s.fastest_mps, f.spray_mps);
    tank_m = std::max(tank_m, f.tank_m);
  }
  s.tanks = problem.path.length_m() / (tank_m + 1e-6);
  return s;
}

/// The makespan that prices refute, which rises.
class Refuted {
 public:
  /// @param service  Slots of a service.
  Refuted(const FleetProblem& problem, const Sizes& sizes, std::size_t service, double from_s,
          std::vector<double> prices)
      : sizes_{sizes},
        slot_s_{sizes.service_s / static_cast<double>(service)},
        time_{static_cast<std::size_t>(from_s / slot_s_) + 1, service, sizes.fill_s / slot_s_},
        split_{problem, slot_s_, 0.5 * slot_s_ * sizes.fastest_mps},
        by_flight_{split_.levels()},
        flights_(split_.levels()),
        split_counts_(split_.levels()),
        prices_{std::move(prices)} {}

  /// Refuted, all of it: no plan is over by then.
  double makespan_s() const { return slot_s_ * static_cast<double>(time_.slots - 1); }
  /// The last prices that refuted one.
  const std::vector<double>& prices() const { return prices_; }

  /// How much the prices break the rule by, as a part of what the split costs, for the least
  /// makespan that they do not refute.
  double operator()(std::span<const double> prices, std::span<double> slope) {
    for (std::size_t j = 0; j < flights_.size(); ++j)
      flights_[j] = std::max(0.0, by_flight_.value(prices.first(knots), j));
    const double split = split_.least(flights_, split_counts_) + prices.back() * sizes_.tanks;
    if (!(split > 0.0)) return 0.0;
    double earned = earn(prices);
    if (earned < split * (1.0 - 1e-9)) prices_.assign(prices.begin(), prices.end());
    while (earned < split * (1.0 - 1e-9)) {
      ++time_.slots;
      earned = earn(prices);
    }
    slopes(prices, slope, earned / split, split);
    return 1.0 - earned / split;
  }

 private:
  double earn(std::span<const double> prices) {
    const Ramp by_time{time_.slots};
    bays_.resize(time_.slots);
    double bay = 0.0;
    for (std::size_t i = 0; i < time_.slots; ++i) {
      bays_[i] = by_time.value(of_bays(prices), i);
      bay += std::max(0.0, bays_[i]);
    }
    const double aircraft = aircraft_.most(time_, {.flights = flights_,
                                                   .sprayed = split_.sprayed(),
                                                   .tank = std::max(0.0, prices.back()),
                                                   .bays = bays_});
    return sizes_.aircraft * aircraft + sizes_.bays * bay;
  }
  static std::span<const double> of_bays(std::span<const double> prices) {
    return prices.subspan(knots, knots);
  }
  void slopes(std::span<const double> prices, std::span<double> slope, double ratio,
              double split) const {
    const Ramp by_time{time_.slots};
    const Earned by = aircraft_.earned();
    std::fill(slope.begin(), slope.end(), 0.0);
    for (std::size_t j = 0; j < flights_.size(); ++j) {
      if (by_flight_.value(prices.first(knots), j) < 0.0) continue;
      const double more = ratio * split_counts_[j] - sizes_.aircraft * by.flights[j];
      by_flight_.add(slope.first(knots), j, more / split);
    }
    for (std::size_t i = 0; i < time_.slots; ++i) {
      const double more = sizes_.aircraft * by.bays[i] - (bays_[i] > 0.0 ? sizes_.bays : 0.0);
      by_time.add(slope.subspan(knots, knots), i, more / split);
    }
    if (time_.whole_fill <= 0.0) return;
    const double tanks = prices.back() < 0.0 ? 0.0 : by.tanks;
    slope.back() = (ratio * sizes_.tanks - sizes_.aircraft * tanks) / split;
  }

  Sizes sizes_;
  double slot_s_;
  Slots time_;
  PricedSplit split_;
  PricedAircraft aircraft_;
  Ramp by_flight_;
  std::vector<double> flights_, bays_{}, split_counts_;
  std::vector<double> prices_;
};

/// Flights by their time, all else at no price: the bound of the work.
std::vector<double> first_prices() {
  std::vector<double> prices(2 * knots + 1, 0.0);
  for (std::size_t k = 0; k < knots; ++k)
    prices[k] = static_cast<double>(k + 1) / static_cast<double>(knots);
  return prices;
}

}  // namespace

double bay_bound_s(const FleetProblem& problem, double from_s, const BayBoundSettings& settings) {
  const Sizes all = sizes(problem);
  if (all.service_s <= 0.0 || all.aircraft <= all.bays) return from_s;
  double bound_s = from_s;
  std::vector<double> prices = first_prices();
  const auto search = [&](double slots, std::uint32_t evaluations) {
    const double service = std::ceil(all.service_s / bound_s * slots);
    const double cell_m = 0.5 * all.service_s / service * all.fastest_mps;
    if (problem.path.length_m() / cell_m > most_cells) return;
    Refuted refuted{problem, all, static_cast<std::size_t>(service), bound_s, prices};
    r_algorithm([&](auto at, auto slope) { return refuted(at, slope); }, prices,
                {.evaluations = evaluations, .step = 0.1});
    bound_s = std::max(bound_s, refuted.makespan_s());
    prices = refuted.prices();
  };
  search(settings.slots, settings.evaluations);
  search(settings.fine_slots, settings.fine_evaluations);
  return bound_s;
}

}  // namespace furrow::planner::fleet
