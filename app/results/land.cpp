#include "app/results/land.hpp"

#include <algorithm>
#include <cmath>

namespace furrow::app {
Area area(const Ring& ring) {
  double twice = 0;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    twice += ring[j].x.base() * ring[i].y.base() - ring[i].x.base() * ring[j].y.base();
  }
  return square_metres(std::abs(twice) / 2);
}

Area area(const Field& field) {
  Area left = area(field.boundary);
  for (const Ring& hole : field.holes) left -= area(hole);
  return left;
}

bool contains(const Field& field, FieldPoint p) {
  return furrow::contains(field.boundary, p) &&
         std::none_of(field.holes.begin(), field.holes.end(),
                      [&](const Ring& hole) { return furrow::contains(hole, p); });
}

}  // namespace furrow::app
