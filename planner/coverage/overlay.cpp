#include "planner/coverage/overlay.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace furrow::planner {
namespace {

constexpr double upright_m = 1e-9;  // edges, and stretches between lines, less wide than that
constexpr double edges_each = 60;   // of a tile, about
constexpr double least_tile_m = 2, most_tile_m = 64;
constexpr double off_grid = 0.38196601;  // so that no vertex lies between tiles

bool covers(const Overlay::Counts& counts) {
  return std::any_of(counts.begin(), counts.end(), [](int n) { return n != 0; });
}

}  // namespace

bool Overlay::Edge::is_upright() const { return to.x - from.x < upright_m; }

// Edges that meet one box.
struct Overlay::Tile {
  BoxM box{};
  Counts corner{};  // what covers the corner `box.low`
  std::vector<const Edge*> edges{};

  // How cover changes along the lower side of the box.
  struct Change {
    double x;
    std::size_t kind;
    int by;
  };

  bool is_along(double x) const { return x > box.low.x && x < box.high.x; }

  std::vector<Change> changes() const {
    std::vector<Change> made;
    for (const Edge* e : edges) {
      const bool is_below = e->from.y < box.low.y;
      if (is_below == (e->to.y < box.low.y)) continue;
      const double share = (box.low.y - e->from.y) / (e->to.y - e->from.y);
      const double x = e->from.x + share * (e->to.x - e->from.x);
      if (is_along(x)) made.push_back({x, e->kind, is_below ? -e->turn : e->turn});
    }
    std::sort(made.begin(), made.end(), [](const Change& a, const Change& b) { return a.x < b.x; });
    return made;
  }

  static std::optional<double> crossing(const Edge& a, const Edge& b) {
    const double low = std::max(a.from.x, b.from.x), high = std::min(a.to.x, b.to.x);
    if (high - low < upright_m) return std::nullopt;
    const double before = a.y_at(low) - b.y_at(low), after = a.y_at(high) - b.y_at(high);
    if ((before > 0) == (after > 0)) return std::nullopt;
    return low + before / (before - after) * (high - low);
  }

  // Where widths within the box change their slope, in order.
  std::vector<double> events() const {
    std::vector<double> at{box.low.x, box.high.x};
    const auto add = [&](double x) {
      if (is_along(x)) at.push_back(x);
    };
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const Edge& e = *edges[i];
      add(e.from.x);
      add(e.to.x);
      for (const double y : {box.low.y, box.high.y}) {
        if ((e.from.y < y) == (e.to.y < y)) continue;
        add(e.from.x + (y - e.from.y) / (e.to.y - e.from.y) * (e.to.x - e.from.x));
      }
      for (std::size_t k = i + 1; k < edges.size(); ++k) {
        if (const auto x = crossing(e, *edges[k])) add(*x);
      }
    }
    std::sort(at.begin(), at.end());
    return at;
  }

  void measure(const Use& use) const {
    if (edges.empty()) {
      const PointM size = box.high - box.low;
      if (covers(corner)) use(corner, size.x * size.y);
      return;
    }
    const std::vector<double> at = events();
    const std::vector<Change> along = changes();
    auto next = along.begin();
    Counts below = corner;
    std::vector<std::pair<double, const Edge*>> met;
    for (std::size_t i = 1; i < at.size(); ++i) {
      const double wide_m = at[i] - at[i - 1], x = (at[i - 1] + at[i]) / 2;
      if (wide_m < upright_m) continue;
      for (; next != along.end() && next->x < x; ++next) below[next->kind] += next->by;
      met.clear();
      for (const Edge* e : edges) {
        if (e->is_upright() || e->from.x >= x || e->to.x <= x) continue;
        const double y = e->y_at(x);
        if (y >= box.low.y && y < box.high.y) met.emplace_back(y, e);
      }
      std::sort(met.begin(), met.end());
      climb(below, met, wide_m, use);
    }
  }

  // Up one line, from the lower side of the box to the upper.
  void climb(Counts counts, const std::vector<std::pair<double, const Edge*>>& met, double wide_m,
             const Use& use) const {
    double y = box.low.y;
    for (const auto& [place, edge] : met) {
      if (place > y && covers(counts)) use(counts, (place - y) * wide_m);
      counts[edge->kind] += edge->turn;
      y = place;
    }
    if (covers(counts)) use(counts, (box.high.y - y) * wide_m);
  }
};

void Overlay::add(const LandPart& part, std::size_t kind) {
  add_ring(part.outer, false, kind);
  for (const RingM& hole : part.holes) add_ring(hole, true, kind);
}

void Overlay::add_ring(const RingM& ring, bool is_hole, std::size_t kind) {
  const int inwards = (signed_area_m2(ring) > 0) == is_hole ? -1 : 1;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    PointM from = frame_.to(ring[i]), to = frame_.to(ring[(i + 1) % ring.size()]);
    const bool is_onwards = from.x <= to.x;
    if (!is_onwards) std::swap(from, to);
    edges_.push_back({from, to, kind, is_onwards ? inwards : -inwards});
  }
}

// Tiles that hold all edges.
class Overlay::Mosaic {
 public:
  explicit Mosaic(const std::vector<Edge>& edges) : low_{edges[0].from} {
    PointM high = low_;
    for (const Edge& e : edges) {
      low_ = {std::min(low_.x, e.from.x), std::min({low_.y, e.from.y, e.to.y})};
      high = {std::max(high.x, e.to.x), std::max({high.y, e.from.y, e.to.y})};
    }
    const double each_m2 =
        (high.x - low_.x) * (high.y - low_.y) * edges_each / static_cast<double>(edges.size());
    side_m_ = std::clamp(std::sqrt(each_m2), least_tile_m, most_tile_m);
    low_ = low_ - side_m_ * PointM{off_grid, off_grid};
    columns_ = number(high.x - low_.x) + 1;
    lines_ = number(high.y - low_.y) + 1;
    tiles_.resize(columns_ * lines_);
    for (std::size_t t = 0; t < tiles_.size(); ++t) tiles_[t].box = box(t);
    for (const Edge& e : edges) put(e);
  }
  const std::vector<Tile>& tiles() const { return tiles_; }

 private:
  std::size_t number(double from_low_m) const {
    return static_cast<std::size_t>(from_low_m / side_m_);
  }
  BoxM box(std::size_t t) const {
    const std::size_t column = t % columns_, line = t / columns_;
    const PointM place{static_cast<double>(column), static_cast<double>(line)};
    return {low_ + side_m_ * place, low_ + side_m_ * (place + PointM{1, 1})};
  }

  void put(const Edge& e) {
    for (std::size_t c = number(e.from.x - low_.x); c <= number(e.to.x - low_.x); ++c) {
      const BoxM& lowest = tiles_[c].box;
      double a = e.from.y, b = e.to.y;
      if (!e.is_upright()) {
        a = e.y_at(std::max(e.from.x, lowest.low.x));
        b = e.y_at(std::min(e.to.x, lowest.high.x));
      }
      const std::size_t first = number(std::min(a, b) - low_.y);
      const std::size_t last = number(std::max(a, b) - low_.y);
      for (std::size_t l = first; l <= last; ++l) tiles_[l * columns_ + c].edges.push_back(&e);
      const bool meets_side = e.from.x < lowest.low.x && e.to.x >= lowest.low.x;
      if (meets_side && !e.is_upright()) lift(e, c, a);
    }
  }

  // Corners above the place where an edge meets their column's left side.
  void lift(const Edge& e, std::size_t column, double y) {
    for (std::size_t l = number(y - low_.y); l < lines_; ++l) {
      Tile& tile = tiles_[l * columns_ + column];
      if (y < tile.box.low.y) tile.corner[e.kind] += e.turn;
    }
  }

  PointM low_;
  double side_m_ = 0;
  std::size_t columns_ = 0, lines_ = 0;
  std::vector<Tile> tiles_{};
};

void Overlay::measure(const Use& use) const {
  if (edges_.empty()) return;
  const Mosaic mosaic{edges_};
  for (const Tile& tile : mosaic.tiles()) tile.measure(use);
}

}  // namespace furrow::planner
