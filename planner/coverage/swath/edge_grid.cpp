#include "planner/coverage/swath/edge_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace furrow::planner {
namespace {

// Where a way meets edges without leaving the land: nearly always few, kept without allocating.
class Touches {
 public:
  void add(double at_m) {
    if (count_ < few_.size()) {
      few_[count_++] = at_m;
    } else {
      many_.push_back(at_m);
    }
  }
  std::span<const double> sorted() {
    if (many_.empty()) {
      std::sort(few_.begin(), few_.begin() + static_cast<std::ptrdiff_t>(count_));
      return {few_.data(), count_};
    }
    many_.insert(many_.end(), few_.begin(), few_.end());
    std::sort(many_.begin(), many_.end());
    return many_;
  }

 private:
  std::array<double, 32> few_;  // of which `count_` are set
  std::size_t count_ = 0;
  std::vector<double> many_{};
};

}  // namespace

EdgeGrid::EdgeGrid(const LandPart& part) {
  const auto add_ring = [&](const RingM& ring, int number) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      edges_.push_back({ring[i], ring[(i + 1) % ring.size()], number, static_cast<int>(i)});
    }
  };
  add_ring(part.outer, 0);
  for (std::size_t h = 0; h < part.holes.size(); ++h) {
    add_ring(part.holes[h], static_cast<int>(h) + 1);
  }
  low_ = high_ = part.outer.front();
  for (const PointM p : part.outer) {
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
    high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
  }
  const double side = std::clamp(std::sqrt(static_cast<double>(edges_.size())), 1.0, 256.0);
  columns_ = lines_ = static_cast<std::size_t>(side);
  cell_x_m_ = std::max((high_.x - low_.x) / static_cast<double>(columns_), 1e-9);
  cell_y_m_ = std::max((high_.y - low_.y) / static_cast<double>(lines_), 1e-9);
  cells_.resize(columns_ * lines_);
  bands_.resize(lines_);
  stacks_.resize(columns_);
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const PointM a = edges_[e].from, b = edges_[e].to;
    const std::size_t c0 = column_of(std::min(a.x, b.x) - touch_m);
    const std::size_t c1 = column_of(std::max(a.x, b.x) + touch_m);
    const std::size_t l0 = line_of(std::min(a.y, b.y) - touch_m);
    const std::size_t l1 = line_of(std::max(a.y, b.y) + touch_m);
    for (std::size_t c = c0; c <= c1; ++c) stacks_[c].push_back(e);
    for (std::size_t l = l0; l <= l1; ++l) {
      bands_[l].push_back(e);
      for (std::size_t c = c0; c <= c1; ++c) cells_[l * columns_ + c].push_back(e);
    }
  }
}

std::size_t EdgeGrid::column_of(double x) const {
  const double c = std::floor((x - low_.x) / cell_x_m_);
  return static_cast<std::size_t>(std::clamp(c, 0.0, static_cast<double>(columns_ - 1)));
}

std::size_t EdgeGrid::line_of(double y) const {
  const double l = std::floor((y - low_.y) / cell_y_m_);
  return static_cast<std::size_t>(std::clamp(l, 0.0, static_cast<double>(lines_ - 1)));
}

// Calls `use(edge)` for all edges in the cells that the way from a to b meets, until it returns
// false. An edge may come more than once.
template <class Use>
void EdgeGrid::each_near(PointM a, PointM b, Use use) const {
  const std::size_t l0 = line_of(std::min(a.y, b.y) - touch_m);
  const std::size_t l1 = line_of(std::max(a.y, b.y) + touch_m);
  for (std::size_t l = l0; l <= l1; ++l) {
    double x0 = std::min(a.x, b.x), x1 = std::max(a.x, b.x);
    if (l0 != l1 && std::abs(b.y - a.y) > touch_m) {  // the part of the way in this line of cells
      const double bottom = low_.y + static_cast<double>(l) * cell_y_m_;
      const auto x_at = [&](double y) { return a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x); };
      const double xa = x_at(bottom - touch_m), xb = x_at(bottom + cell_y_m_ + touch_m);
      // The outermost lines of cells stand for everything beyond them.
      if (l != 0 && l != lines_ - 1) {
        x0 = std::max(x0, std::min(xa, xb));
        x1 = std::min(x1, std::max(xa, xb));
      }
    }
    const std::size_t c1 = column_of(x1 + touch_m);
    for (std::size_t c = column_of(x0 - touch_m); c <= c1; ++c) {
      for (const std::size_t e : cells_[l * columns_ + c]) {
        if (!use(edges_[e])) return;
      }
    }
  }
}

const EdgeGrid::Edge* EdgeGrid::edge_at(PointM p) const {
  const Edge* found = nullptr;
  each_near(p, p, [&](const Edge& edge) {
    if (distance_m(p, edge.from, edge.to) <= touch_m) found = &edge;
    return found == nullptr;
  });
  return found;
}

// Whether the place lies to the left of an odd number of edges.
bool EdgeGrid::is_left_of_odd(PointM p) const {
  bool odd = false;
  for (const std::size_t e : bands_[line_of(p.y)]) {
    const PointM a = edges_[e].from, b = edges_[e].to;
    if ((a.y <= p.y) == (b.y <= p.y)) continue;
    if (a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) > p.x) odd = !odd;
  }
  return odd;
}

bool EdgeGrid::is_below_odd(PointM p) const {
  bool odd = false;
  for (const std::size_t e : stacks_[column_of(p.x)]) {
    const PointM a = edges_[e].from, b = edges_[e].to;
    if ((a.x <= p.x) == (b.x <= p.x)) continue;
    if (a.y + (p.x - a.x) / (b.x - a.x) * (b.y - a.y) > p.y) odd = !odd;
  }
  return odd;
}

bool EdgeGrid::contains(PointM p) const {
  if (edge_at(p)) return true;
  if (p.y < low_.y || p.y > high_.y || p.x < low_.x || p.x > high_.x) return false;
  const bool is_shorter_up = stacks_[column_of(p.x)].size() < bands_[line_of(p.y)].size();
  return is_shorter_up ? is_below_odd(p) : is_left_of_odd(p);
}

bool EdgeGrid::sees(PointM a, PointM b) const {
  const double length_m = norm(b - a);
  if (length_m <= touch_m) return true;
  const PointM along = (1 / length_m) * (b - a);
  Touches touches;
  touches.add(0);
  touches.add(length_m);
  bool blocked = false;
  each_near(a, b, [&](const Edge& edge) {
    const double side_from = cross(along, edge.from - a), side_to = cross(along, edge.to - a);
    const double t_from = dot(along, edge.from - a), t_to = dot(along, edge.to - a);
    if (std::abs(side_from) <= touch_m) touches.add(t_from);
    if (std::abs(side_to) <= touch_m) touches.add(t_to);
    if (std::abs(side_from) <= touch_m || std::abs(side_to) <= touch_m ||
        (side_from > 0) == (side_to > 0)) {
      return true;
    }
    const double t = t_from + (t_to - t_from) * side_from / (side_from - side_to);
    if (t < -touch_m || t > length_m + touch_m) return true;
    const bool ends_on_edge = distance_m(a, edge.from, edge.to) <= touch_m ||
                              distance_m(b, edge.from, edge.to) <= touch_m;
    if (ends_on_edge) {
      touches.add(t);
      return true;
    }
    blocked = true;
    return false;
  });
  if (blocked) return false;
  const std::span<const double> at = touches.sorted();
  for (std::size_t i = 1; i < at.size(); ++i) {
    const double from = std::clamp(at[i - 1], 0.0, length_m);
    const double to = std::clamp(at[i], 0.0, length_m);
    if (to - from > 2 * touch_m && !contains(a + ((from + to) / 2) * along)) return false;
  }
  return true;
}

}  // namespace furrow::planner
