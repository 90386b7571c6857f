#include "planner/routes/ants.hpp"

#include "core/require.hpp"

#include <algorithm>

namespace furrow::planner {
namespace {

using Choices = std::vector<std::size_t>;  // a place of each layer

class Colony {
 public:
  Colony(const Scene& scene, const AntSettings& settings, std::uint64_t seed)
      : settings_{settings},
        places_{std::size_t{settings.across} * settings.upwards},
        judge_{scene},
        random_{seed},
        pheromone_(settings.layers * places_ * places_, 1.0),
        weights_(places_) {
    for (std::uint32_t layer = 0; layer < settings.layers; ++layer) lay_out(layer);
    for (std::uint32_t layer = 0; layer < settings.layers; ++layer) weigh(layer);
  }

  RouteSearch run(double evaluations) && {
    while (judge_.evaluations() < evaluations) generation();
    return {std::move(best_), std::move(history_), judge_.evaluations()};
  }

 private:
  // Across the straight line at an equal share of it, as far as the box reaches.
  void lay_out(std::uint32_t layer) {
    const Scene& s = judge_.scene();
    const WayPoint at = between(s.start, s.goal, (layer + 1.0) / (settings_.layers + 1.0));
    const double run = std::hypot(s.goal.x_m - s.start.x_m, s.goal.y_m - s.start.y_m);
    const double ux = run > 0 ? -(s.goal.y_m - s.start.y_m) / run : 1;
    const double uy = run > 0 ? (s.goal.x_m - s.start.x_m) / run : 0;
    const double reach_m = std::hypot(s.high.x_m - s.low.x_m, s.high.y_m - s.low.y_m) / 2;
    for (std::uint32_t i = 0; i < settings_.across; ++i) {
      const double aside = reach_m * (2.0 * i / (settings_.across - 1) - 1);
      const double x = std::clamp(at.x_m + ux * aside, s.low.x_m, s.high.x_m);
      const double y = std::clamp(at.y_m + uy * aside, s.low.y_m, s.high.y_m);
      for (std::uint32_t k = 0; k < settings_.upwards; ++k) {
        const double t = static_cast<double>(k) / (settings_.upwards - 1);
        grid_.push_back({x, y, s.low.z_m + t * (s.high.z_m - s.low.z_m)});
      }
    }
  }

  // How near each step keeps to the direct way; the first layer has one place to come from.
  void weigh(std::uint32_t layer) {
    const Scene& s = judge_.scene();
    for (std::size_t from = 0; from < places_; ++from) {
      const WayPoint at = layer == 0 ? s.start : place(layer - 1, from);
      for (std::size_t to = 0; to < places_; ++to) {
        const WayPoint p = place(layer, to);
        const double way_m = distance_m(at, p) + distance_m(p, s.goal);
        nearness_.push_back(std::pow(distance_m(at, s.goal) / way_m, settings_.nearness_power));
      }
    }
  }

  void generation() {
    Choices best_choices;
    Individual best;
    for (std::uint32_t ant = 0; ant < settings_.ants; ++ant) {
      Choices choices = walk();
      Individual one{genes(choices), {}};
      one.cost = judge_.cost(one.genes);
      if (best_choices.empty() || one.cost.total() < best.cost.total()) {
        best = std::move(one);
        best_choices = std::move(choices);
      }
    }
    if (history_.empty() || best.cost.total() < best_.cost.total()) {
      best_ = best;
      best_choices_ = best_choices;
    }
    for (double& p : pheromone_) p = std::max(least, p * (1 - settings_.evaporation));
    lay(best_choices, best.cost);
    lay(best_choices_, best_.cost);
    history_.push_back(best_.cost.total());
  }

  Choices walk() {
    Choices choices;
    std::size_t from = 0;
    for (std::uint32_t layer = 0; layer < settings_.layers; ++layer) {
      choices.push_back(random_.uniform() < settings_.fresh_share ? random_.below(places_)
                                                                  : chosen(layer, from));
      from = choices.back();
    }
    return choices;
  }

  std::size_t chosen(std::uint32_t layer, std::size_t from) {
    double sum = 0;
    for (std::size_t to = 0; to < places_; ++to) {
      sum += trail(layer, from, to) * nearness_[step(layer, from, to)];
      weights_[to] = sum;
    }
    const auto slot =
        std::upper_bound(weights_.begin(), weights_.end() - 1, random_.uniform(0, sum));
    return static_cast<std::size_t>(slot - weights_.begin());
  }

  void lay(const Choices& choices, const RouteCost& cost) {
    const Scene& s = judge_.scene();
    std::size_t from = 0;
    for (std::uint32_t layer = 0; layer < settings_.layers; ++layer) {
      trail(layer, from, choices[layer]) += distance_m(s.start, s.goal) / cost.total();
      from = choices[layer];
    }
  }

  Genes genes(const Choices& choices) const {
    Genes genes;
    for (std::uint32_t layer = 0; layer < settings_.layers; ++layer) {
      genes.push_back(place(layer, choices[layer]));
    }
    return genes;
  }

  double& trail(std::uint32_t layer, std::size_t from, std::size_t to) {
    return pheromone_[step(layer, from, to)];
  }
  std::size_t step(std::uint32_t layer, std::size_t from, std::size_t to) const {
    return (layer * places_ + from) * places_ + to;
  }
  WayPoint place(std::uint32_t layer, std::size_t i) const { return grid_[layer * places_ + i]; }

  static constexpr double least = 0.01;  // of pheromone: no step dies out

  AntSettings settings_;
  std::size_t places_;
  RouteJudge judge_;
  Random random_;
  std::vector<WayPoint> grid_;
  std::vector<double> pheromone_;
  std::vector<double> nearness_;
  std::vector<double> weights_;
  Individual best_;
  Choices best_choices_;
  std::vector<double> history_;
};

}  // namespace

RouteSearch ant_route(const Scene& scene, const AntSettings& settings, std::uint64_t evaluations,
                      std::uint64_t seed) {
  require(settings.ants >= 1 && settings.layers >= 1 && settings.layers <= 30 &&
              settings.across >= 2 && settings.upwards >= 2,
          "ants have layers with places to choose from");
  return Colony{scene, settings, seed}.run(static_cast<double>(evaluations));
}

}  // namespace furrow::planner
