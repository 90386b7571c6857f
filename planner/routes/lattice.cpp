#include "planner/routes/lattice.hpp"

#include "planner/routes/smoothing.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <queue>

namespace furrow::planner {
namespace {

constexpr double share_for_search = 0.5;
constexpr double places_per_node = 60;  // looked up at each node: itself, half of 26 steps of four
constexpr int looks_per_step = 4;

class Lattice {
 public:
  explicit Lattice(RouteJudge& judge, double evaluations) : judge_{judge}, scene_{judge.scene()} {
    const double nodes = share_for_search * evaluations * curve_samples / places_per_node;
    const double wide_m = scene_.high.x_m - scene_.low.x_m,
                 deep_m = scene_.high.y_m - scene_.low.y_m;
    // Twice as many along the longer side as upwards.
    const double n = std::cbrt(nodes / 4 * std::max(wide_m, deep_m) / std::min(wide_m, deep_m));
    const auto at_least = [](double v) { return static_cast<int>(std::clamp(v, 4.0, 400.0)); };
    size_ = {at_least(2 * n * wide_m / std::max(wide_m, deep_m)),
             at_least(2 * n * deep_m / std::max(wide_m, deep_m)), at_least(n)};
    pitch_ = {wide_m / (size_[0] - 1), deep_m / (size_[1] - 1),
              (scene_.high.z_m - scene_.low.z_m) / (size_[2] - 1)};
    const std::size_t count = index(size_[0]) * index(size_[1]) * index(size_[2]);
    cost_.assign(count, std::numeric_limits<double>::infinity());
    from_.assign(count, -1);
    is_closed_.assign(count, false);
  }

  double step_m() const { return std::hypot(pitch_.x_m, pitch_.y_m) / looks_per_step; }

  /// Corners from start to goal; empty where there is no way.
  std::vector<WayPoint> way() {
    enter();
    while (!open_.empty()) {
      const int node = open_.top().second;
      open_.pop();
      if (is_closed_[index(node)]) continue;
      is_closed_[index(node)] = true;
      if (is_near(place(node), scene_.goal) && sees(place(node), scene_.goal)) return back(node);
      expand(node);
    }
    return {};
  }

 private:
  static std::size_t index(int node) { return static_cast<std::size_t>(node); }
  int node(int i, int j, int k) const { return (k * size_[1] + j) * size_[0] + i; }
  std::array<int, 3> parts(int n) const {
    return {n % size_[0], n / size_[0] % size_[1], n / size_[0] / size_[1]};
  }
  WayPoint place(int n) const {
    const auto [i, j, k] = parts(n);
    return {scene_.low.x_m + i * pitch_.x_m, scene_.low.y_m + j * pitch_.y_m,
            scene_.low.z_m + k * pitch_.z_m};
  }
  bool is_near(WayPoint a, WayPoint b) const {
    return std::abs(a.x_m - b.x_m) <= pitch_.x_m && std::abs(a.y_m - b.y_m) <= pitch_.y_m &&
           std::abs(a.z_m - b.z_m) <= 2 * pitch_.z_m;
  }
  bool sees(WayPoint a, WayPoint b) { return judge_.is_clear(a, b, step_m()); }

  void enter() {
    for (int n = 0; n < static_cast<int>(cost_.size()); ++n) {
      if (is_near(place(n), scene_.start) && sees(scene_.start, place(n))) {
        reach(n, -1, distance_m(scene_.start, place(n)));
      }
    }
  }

  void expand(int from) {
    const auto [i, j, k] = parts(from);
    for (int di = -1; di <= 1; ++di) {
      for (int dj = -1; dj <= 1; ++dj) {
        for (int dk = -1; dk <= 1; ++dk) try_step(from, i + di, j + dj, k + dk);
      }
    }
  }

  void try_step(int from, int i, int j, int k) {
    if (std::min({i, j, k}) < 0 || i >= size_[0] || j >= size_[1] || k >= size_[2]) return;
    const int to = node(i, j, k);
    const double cost = cost_[index(from)] + distance_m(place(from), place(to));
    if (is_closed_[index(to)] || cost >= cost_[index(to)]) return;
    const bool is_level_step = scene_.steepest_climb >= climb(place(from), place(to));
    if (is_level_step && sees(place(from), place(to))) reach(to, from, cost);
  }

  static double climb(WayPoint a, WayPoint b) {
    const double run = std::hypot(a.x_m - b.x_m, a.y_m - b.y_m), rise = std::abs(a.z_m - b.z_m);
    return rise == 0 ? 0 : rise / std::max(run, 1e-9);
  }

  void reach(int to, int from, double cost) {
    cost_[index(to)] = cost;
    from_[index(to)] = from;
    open_.push({cost + distance_m(place(to), scene_.goal), to});
  }

  std::vector<WayPoint> back(int node) const {
    std::vector<WayPoint> line{scene_.goal};
    for (; node >= 0; node = from_[index(node)]) line.push_back(place(node));
    line.push_back(scene_.start);
    std::reverse(line.begin(), line.end());
    return line;
  }

  using Open = std::pair<double, int>;  // bound of the whole way, node
  RouteJudge& judge_;
  const Scene& scene_;
  std::array<int, 3> size_;
  WayPoint pitch_;
  std::vector<double> cost_;
  std::vector<int> from_;
  std::vector<bool> is_closed_;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open_;
};

}  // namespace

RouteSearch lattice_route(const Scene& scene, std::uint64_t evaluations, std::uint64_t seed) {
  RouteJudge judge{scene};
  Random random{seed};
  const auto budget = static_cast<double>(evaluations);
  Lattice lattice{judge, budget};
  std::vector<WayPoint> line = lattice.way();
  if (line.empty()) {
    line = {scene.start, scene.goal};
  } else {
    line = pulled(line, judge, lattice.step_m());
  }
  Individual best = fitted(line, judge);
  std::vector<double> history{best.cost.total()};
  best = settled(std::move(best), judge, budget, random);
  history.push_back(best.cost.total());
  return {std::move(best), std::move(history), judge.evaluations()};
}

}  // namespace furrow::planner
