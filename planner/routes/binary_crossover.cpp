#include "planner/routes/binary_crossover.hpp"

#include <algorithm>

namespace furrow::planner {
namespace {

double spread(double eta, Random& random) {
  const double u = random.uniform();
  const double base = u <= 0.5 ? 2 * u : 0.5 / (1 - u);
  return std::pow(base, 1 / (eta + 1));
}

}  // namespace

std::pair<Genes, Genes> binary_crossover(const Genes& a, const Genes& b, const Scene& scene,
                                         double eta, Random& random) {
  std::pair<Genes, Genes> children{a, b};
  const auto cross = [&](double& x, double& y, double low, double high) {
    const double beta = spread(eta, random), middle = (x + y) / 2, half = beta * (y - x) / 2;
    x = std::clamp(middle - half, low, high);
    y = std::clamp(middle + half, low, high);
  };
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    WayPoint &p = children.first[i], &q = children.second[i];
    cross(p.x_m, q.x_m, scene.low.x_m, scene.high.x_m);
    cross(p.y_m, q.y_m, scene.low.y_m, scene.high.y_m);
    cross(p.z_m, q.z_m, scene.low.z_m, scene.high.z_m);
  }
  return children;
}

}  // namespace furrow::planner
