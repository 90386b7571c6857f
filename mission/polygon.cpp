#include "mission/polygon.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace furrow::mission {
namespace {

// In metres; a plain copy, so that the inner loops read plain doubles.
struct Vertex {
  double x, y;
};

struct Edge {
  Vertex a, b;
  std::size_t index, ring_size;  // Which edge of how many.
};

Vertex vertex(FieldPoint p) { return {p.x.base(), p.y.base()}; }

double turn(Vertex a, Vertex b, Vertex c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

int side(Vertex a, Vertex b, Vertex c) {
  const double t = turn(a, b, c);
  return (t > 0) - (t < 0);
}

bool in_box(Vertex p, const Edge& e) {
  return std::min(e.a.x, e.b.x) <= p.x && p.x <= std::max(e.a.x, e.b.x) &&
         std::min(e.a.y, e.b.y) <= p.y && p.y <= std::max(e.a.y, e.b.y);
}

bool touch(const Edge& e, const Edge& f) {
  const int e1 = side(f.a, f.b, e.a), e2 = side(f.a, f.b, e.b);
  const int f1 = side(e.a, e.b, f.a), f2 = side(e.a, e.b, f.b);
  if (e1 * e2 < 0 && f1 * f2 < 0) return true;
  return (e1 == 0 && in_box(e.a, f)) || (e2 == 0 && in_box(e.b, f)) ||
         (f1 == 0 && in_box(f.a, e)) || (f2 == 0 && in_box(f.b, e));
}

// Neighbouring edges share a vertex; they are at fault only when one runs back over the other.
bool fold_back(const Edge& e, const Edge& next) {
  const double along =
      (e.b.x - e.a.x) * (next.b.x - next.a.x) + (e.b.y - e.a.y) * (next.b.y - next.a.y);
  return side(e.a, e.b, next.b) == 0 && along < 0;
}

bool at_fault(const Edge& e, const Edge& f) {
  const std::size_t n = e.ring_size;
  const bool before = (e.index + 1) % n == f.index, after = (f.index + 1) % n == e.index;
  if (before || after) return (before && fold_back(e, f)) || (after && fold_back(f, e));
  return touch(e, f);
}

std::vector<Edge> edges_of(const Ring& ring) {
  std::vector<Edge> edges;
  edges.reserve(ring.size());
  for (std::size_t i = 0; i < ring.size(); ++i) {
    edges.push_back({vertex(ring[i]), vertex(ring[(i + 1) % ring.size()]), i, ring.size()});
  }
  return edges;
}

std::string text(const Edge& e) {
  return fmt::format("edge ({:.10g}, {:.10g})-({:.10g}, {:.10g})", e.a.x, e.a.y, e.b.x, e.b.y);
}

// The first pair at fault from west to east.
std::optional<std::string> first_fault(std::vector<Edge> edges) {
  const auto west = [](const Edge& e) { return std::min(e.a.x, e.b.x); };
  std::stable_sort(edges.begin(), edges.end(),
                   [&](const Edge& e, const Edge& f) { return west(e) < west(f); });
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const double east = std::max(edges[i].a.x, edges[i].b.x);
    for (std::size_t j = i + 1; j < edges.size() && west(edges[j]) <= east; ++j) {
      if (!at_fault(edges[i], edges[j])) continue;
      return fmt::format("{} meets {}", text(edges[i]), text(edges[j]));
    }
  }
  return {};
}

double distance_m(Vertex p, Vertex a, Vertex b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double along = ((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy);
  const double t = std::clamp(along, 0.0, 1.0);
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

}  // namespace

std::string text(FieldPoint p) { return fmt::format("({:.10g}, {:.10g})", p.x.base(), p.y.base()); }

Area area(const Ring& ring) {
  double twice_m2 = 0;
  const Vertex origin = vertex(ring.front());
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    twice_m2 += turn(origin, vertex(ring[i]), vertex(ring[i + 1]));
  }
  return square_metres(std::abs(twice_m2) / 2);
}

Area area(const Field& field) {
  Area left = area(field.boundary);
  for (const Ring& hole : field.holes) left -= area(hole);
  return left;
}

std::optional<std::string> ring_fault(const Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (ring[i] == ring[(i + 1) % ring.size()]) {
      return fmt::format("must not repeat a vertex: {} stands twice in a row", text(ring[i]));
    }
  }
  if (const auto fault = first_fault(edges_of(ring))) {
    return fmt::format("must not cross or touch itself: {}", *fault);
  }
  constexpr double least_m2 = 1;
  const double m2 = area(ring).base();
  if (m2 < least_m2) {
    return fmt::format("must enclose at least {} m2: it encloses {:.4g} m2 at {}", least_m2, m2,
                       text(ring.front()));
  }
  return {};
}

bool is_inside(FieldPoint point, const Ring& ring) {
  const Vertex p = vertex(point);
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Edge e{vertex(ring[i]), vertex(ring[(i + 1) % ring.size()]), i, ring.size()};
    if (side(e.a, e.b, p) == 0 && in_box(p, e)) return false;
    if ((e.a.y > p.y) != (e.b.y > p.y)) {
      inside ^= (turn(e.a, e.b, p) > 0) == (e.b.y > e.a.y);
    }
  }
  return inside;
}

Length distance(FieldPoint p, const Ring& ring) {
  if (is_inside(p, ring)) return {};
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    least_m = std::min(least_m,
                       distance_m(vertex(p), vertex(ring[i]), vertex(ring[(i + 1) % ring.size()])));
  }
  return metres(least_m);
}

}  // namespace furrow::mission
