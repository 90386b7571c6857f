#include "planner/routes/reach_map.hpp"

#include "core/require.hpp"
#include "planner/routes/route_cost.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <queue>

namespace furrow::planner {
namespace {

constexpr int looks_per_pitch = 2;

struct Node {
  int from = -2;  // -2: not seen, -1: the start
  FlightCost out{std::numeric_limits<double>::infinity(), 0};
  FlightCost back{};
  bool is_settled = false;
};

class Spread {
 public:
  Spread(const Scene& scene, const AirSpeeds& speeds, std::array<int, 3> size, WayPoint pitch)
      : judge_{scene},
        scene_{scene},
        speeds_{speeds},
        size_{size},
        pitch_{pitch},
        look_m_{std::min(pitch.x_m, pitch.y_m) / looks_per_pitch},
        nodes_(static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) *
               static_cast<std::size_t>(size[2])) {}

  std::vector<Node> run() && {
    enter();
    while (!open_.empty()) {
      const double cost = open_.top().first;
      const int n = open_.top().second;
      open_.pop();
      const bool is_stale = at(n).from == -2 || cost > at(n).out.time_s;
      if (at(n).is_settled || is_stale) continue;
      if (!settle(n)) continue;
      for_neighbours(n, [&](int m) { offer(m, at(n).from); });
    }
    return std::move(nodes_);
  }

  WayPoint place(int n) const {
    const int i = n % size_[0], j = n / size_[0] % size_[1], k = n / size_[0] / size_[1];
    return {scene_.low.x_m + i * pitch_.x_m, scene_.low.y_m + j * pitch_.y_m,
            scene_.low.z_m + k * pitch_.z_m};
  }

  bool sees(WayPoint a, WayPoint b) { return judge_.is_clear(a, b, look_m_); }

 private:
  Node& at(int n) { return nodes_[static_cast<std::size_t>(n)]; }
  WayPoint origin(int from) const { return from < 0 ? scene_.start : place(from); }

  template <class Visit>
  void for_neighbours(int n, Visit visit) {
    const int i = n % size_[0], j = n / size_[0] % size_[1], k = n / size_[0] / size_[1];
    for (int dk = -1; dk <= 1; ++dk) {
      for (int dj = -1; dj <= 1; ++dj) {
        for (int di = -1; di <= 1; ++di) {
          const int x = i + di, y = j + dj, z = k + dk;
          const bool is_inside =
              std::min({x, y, z}) >= 0 && x < size_[0] && y < size_[1] && z < size_[2];
          if (is_inside && (di || dj || dk)) visit((z * size_[1] + y) * size_[0] + x);
        }
      }
    }
  }

  // From the start to the corners of its cell and the places above them.
  void enter() {
    for (int n = 0; n < static_cast<int>(nodes_.size()); ++n) {
      const WayPoint p = place(n);
      if (std::abs(p.x_m - scene_.start.x_m) <= pitch_.x_m &&
          std::abs(p.y_m - scene_.start.y_m) <= pitch_.y_m && sees(scene_.start, p)) {
        take(n, -1);
      }
    }
  }

  FlightCost out(int from, int to) const {
    const FlightCost before = from < 0 ? FlightCost{} : nodes_[static_cast<std::size_t>(from)].out;
    return before + flight_cost(origin(from), place(to), speeds_);
  }

  void take(int n, int from) {
    Node& node = at(n);
    node.from = from;
    node.out = out(from, n);
    node.back =
        (from < 0 ? FlightCost{} : at(from).back) + flight_cost(place(n), origin(from), speeds_);
    open_.push({node.out.time_s, n});
  }

  // As if the neighbour saw the place before, which settling it will tell.
  void offer(int m, int from) {
    if (!at(m).is_settled && out(from, m).time_s < at(m).out.time_s) take(m, from);
  }

  // Whether n is reached at its cost; if it is not, it has gone back to wait at a higher one.
  bool settle(int n) {
    Node& node = at(n);
    if (is_confirmed(n) || sees(origin(node.from), place(n))) {
      node.is_settled = true;
      return true;
    }
    int best = -2;
    double least_s = std::numeric_limits<double>::infinity();
    for_neighbours(n, [&](int m) {
      if (!at(m).is_settled || out(m, n).time_s >= least_s || !sees(place(m), place(n))) return;
      best = m;
      least_s = out(m, n).time_s;
    });
    node.out.time_s = std::numeric_limits<double>::infinity();
    node.from = -2;
    if (best >= 0) {
      take(n, best);
      confirmed_.resize(nodes_.size(), -2);
      confirmed_[static_cast<std::size_t>(n)] = best;
    }
    return false;
  }

  bool is_confirmed(int n) {
    return !confirmed_.empty() && confirmed_[static_cast<std::size_t>(n)] == at(n).from;
  }

  using Open = std::pair<double, int>;
  RouteJudge judge_;
  const Scene& scene_;
  AirSpeeds speeds_;
  std::array<int, 3> size_;
  WayPoint pitch_;
  double look_m_;
  std::vector<Node> nodes_;
  std::vector<int> confirmed_;  // the neighbour a node was seen from
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open_;
};

}  // namespace

FlightCost flight_cost(WayPoint a, WayPoint b, const AirSpeeds& speeds) {
  const double rise_m = b.z_m - a.z_m;
  const double vertical_s = rise_m > 0 ? rise_m / speeds.climb_mps : -rise_m / speeds.descent_mps;
  const double time_s = std::max(distance_m(a, b) / speeds.level_mps, vertical_s);
  return {time_s, time_s + speeds.climb_energy_s_per_m * std::max(0.0, rise_m)};
}

ReachMap::ReachMap(const Scene& scene, const AirSpeeds& speeds, std::uint32_t columns,
                   std::uint32_t rows, std::uint32_t levels)
    : low_{scene.low}, columns_{columns}, rows_{rows}, start_{scene.start} {
  require(columns >= 2 && rows >= 2 && levels >= 2, "a lattice has two places on each axis");
  pitch_ = {(scene.high.x_m - scene.low.x_m) / (columns - 1),
            (scene.high.y_m - scene.low.y_m) / (rows - 1),
            (scene.high.z_m - scene.low.z_m) / (levels - 1)};
  const std::array<int, 3> size{static_cast<int>(columns), static_cast<int>(rows),
                                static_cast<int>(levels)};
  const std::vector<Node> nodes = Spread{scene, speeds, size, pitch_}.run();
  Spread sight{scene, speeds, size, pitch_};
  const std::size_t cells = std::size_t{columns} * rows;
  best_.assign(cells, -1);
  out_.resize(cells);
  back_.resize(cells);
  for (std::size_t c = 0; c < cells; ++c) {
    const WayPoint middle = sight.place(static_cast<int>(c));
    // A hair above the clearance, which rounding must not undercut.
    const double z_m = scene.surface.height_m(middle.x_m, middle.y_m) + kept_m(scene) + 1e-6;
    goals_.push_back({middle.x_m, middle.y_m, z_m});
    for (std::size_t n = c; n < nodes.size(); n += cells) {
      const WayPoint p = sight.place(static_cast<int>(n));
      if (!nodes[n].is_settled || p.z_m < z_m) continue;
      const FlightCost out = nodes[n].out + flight_cost(p, goals_[c], speeds);
      if (best_[c] >= 0 && out.time_s >= out_[c].time_s) continue;
      if (!sight.sees(p, goals_[c])) continue;
      best_[c] = static_cast<int>(n);
      out_[c] = out;
      back_[c] = nodes[n].back + flight_cost(goals_[c], p, speeds);
    }
  }
  for (const Node& node : nodes) from_.push_back(node.from);
}

std::size_t ReachMap::cell(double x_m, double y_m) const {
  const auto nearest = [](double along, std::uint32_t count) {
    return static_cast<std::size_t>(std::clamp(std::round(along), 0.0, count - 1.0));
  };
  return nearest((y_m - low_.y_m) / pitch_.y_m, rows_) * columns_ +
         nearest((x_m - low_.x_m) / pitch_.x_m, columns_);
}

std::vector<WayPoint> ReachMap::way(std::size_t cell) const {
  require(is_reached(cell), "a way leads to a cell that is reached");
  std::vector<WayPoint> corners{goals_[cell]};
  for (int n = best_[cell]; n >= 0; n = from_[static_cast<std::size_t>(n)]) {
    const std::size_t level = static_cast<std::size_t>(n) / cells();
    const WayPoint& column = goals_[static_cast<std::size_t>(n) % cells()];
    corners.push_back({column.x_m, column.y_m, low_.z_m + static_cast<double>(level) * pitch_.z_m});
  }
  corners.push_back(start_);
  std::reverse(corners.begin(), corners.end());
  return corners;
}

}  // namespace furrow::planner
