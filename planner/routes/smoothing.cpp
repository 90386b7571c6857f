#include "planner/routes/smoothing.hpp"

#include <algorithm>

namespace furrow::planner {
namespace {

constexpr std::size_t most_places = 20;

double length_m(const std::vector<WayPoint>& line) {
  double sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += distance_m(line[i - 1], line[i]);
  return sum;
}

// `count` places strictly inside the line, at equal distances.
Genes along(const std::vector<WayPoint>& line, std::size_t count) {
  Genes places;
  const double step_m = length_m(line) / static_cast<double>(count + 1);
  double passed_m = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double piece_m = distance_m(line[i - 1], line[i]);
    while (places.size() < count) {
      const double at_m = static_cast<double>(places.size() + 1) * step_m - passed_m;
      if (at_m > piece_m) break;
      places.push_back(between(line[i - 1], line[i], piece_m > 0 ? at_m / piece_m : 0));
    }
    passed_m += piece_m;
  }
  return places;
}

Genes changed(const Genes& genes, const Scene& scene, Random& random) {
  Genes next = genes;
  const double kind = random.uniform();
  const std::size_t i = random.below(genes.size());
  if (kind < 0.1 && genes.size() > 1) {
    next.erase(next.begin() + static_cast<std::ptrdiff_t>(i));
  } else if (kind < 0.2 && genes.size() < most_places) {
    const WayPoint from = i == 0 ? scene.start : genes[i - 1];
    next.insert(next.begin() + static_cast<std::ptrdiff_t>(i), between(from, genes[i], 0.5));
  } else {
    next[i] = between(genes[i], moved(scene, genes[i], random), std::exp2(-6 * random.uniform()));
  }
  return next;
}

}  // namespace

std::vector<WayPoint> pulled(const std::vector<WayPoint>& line, RouteJudge& judge, double step_m) {
  std::vector<WayPoint> kept{line.front()};
  for (std::size_t i = 0; i + 1 < line.size();) {
    std::size_t next = line.size() - 1;
    while (next > i + 1 && !judge.is_clear(line[i], line[next], step_m)) --next;
    kept.push_back(line[next]);
    i = next;
  }
  return kept;
}

Individual fitted(const std::vector<WayPoint>& line, RouteJudge& judge) {
  Individual best{along(line, 1), {}};
  best.cost = judge.cost(best.genes);
  const auto try_out = [&](Genes genes) {
    const RouteCost cost = judge.cost(genes);
    if (cost.total() < best.cost.total()) best = {std::move(genes), cost};
  };
  if (line.size() > 2 && line.size() <= most_way_points) {
    try_out({line.begin() + 1, line.end() - 1});
  }
  for (std::size_t count = 2; count <= most_places; ++count) try_out(along(line, count));
  return best;
}

Individual settled(Individual one, RouteJudge& judge, double evaluations, Random& random) {
  while (judge.evaluations() + 1 <= evaluations) {
    Genes genes = changed(one.genes, judge.scene(), random);
    const RouteCost cost = judge.cost(genes);
    if (cost.total() < one.cost.total()) one = {std::move(genes), cost};
  }
  return one;
}

}  // namespace furrow::planner
