#include "planner/coverage/swath/areas.hpp"

#include "planner/coverage/swath/geos.hpp"

#include <algorithm>

namespace furrow::planner {
namespace {

constexpr double shortest_m = 1e-9;

LandPart rectangle(PointM a, PointM b, double half_m) {
  const PointM along = (half_m / norm(b - a)) * (b - a);
  const PointM left{-along.y, along.x};
  return {{a - left, b - left, b + left, a + left}, {}};
}

LandParts footprints(const std::vector<SprayedRun>& runs) {
  LandParts made;
  for (const SprayedRun& run : runs) {
    PathM path;
    for (const PointM p : run.path) {
      if (path.empty() || norm(p - path.back()) > shortest_m) path.push_back(p);
    }
    if (path.size() == 2) {
      made.push_back(rectangle(path[0], path[1], run.width_m / 2));
    } else if (path.size() > 2) {
      LandParts wide = widened(path, run.width_m / 2);
      made.insert(made.end(), wide.begin(), wide.end());
    }
  }
  return made;
}

}  // namespace

SprayedAreas sprayed_areas(const std::vector<SprayedRun>& runs, const LandParts& land) {
  const LandParts all = united(footprints(runs));
  double sprayed_m2 = 0;
  for (const SprayedRun& run : runs) sprayed_m2 += length_m(run.path) * run.width_m;
  const double once_m2 = area_m2(all);
  const double outside_m2 = all.empty() ? 0 : area_m2(subtracted(all, land));
  const double covered_m2 = once_m2 - outside_m2;
  return {.sprayed = square_metres(sprayed_m2),
          .covered = square_metres(covered_m2),
          .missed = square_metres(area_m2(land) - covered_m2),
          .repeated = square_metres(sprayed_m2 - once_m2),
          .outside = square_metres(outside_m2)};
}

LandParts missed_land(const std::vector<SprayedRun>& runs, const LandParts& land) {
  return subtracted(land, united(footprints(runs)));
}

}  // namespace furrow::planner
