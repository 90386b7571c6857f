#include "planner/coverage/led_or_ended.hpp"

#include "core/corner.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace furrow::planner {
namespace {

double ground_m2(const Obstacle& o) {
  RingM ring;
  for (const FieldPoint p : o.outline) ring.push_back({p.x.base(), p.y.base()});
  return std::abs(signed_area_m2(ring));
}

// By number, that of the least ground first. Half circles know no ends.
std::vector<std::size_t> large_outlines(const Field& field, Length swath, AvoidanceMethod method) {
  std::vector<std::size_t> large;
  if (method == AvoidanceMethod::classic) return large;
  const auto& all = field.obstacles;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!all[i].outline.empty() && all[i].radius > 2.0 * swath) large.push_back(i);
  }
  std::stable_sort(large.begin(), large.end(), [&](std::size_t a, std::size_t b) {
    return ground_m2(all[a]) < ground_m2(all[b]);
  });
  return large;
}

// Of the way from the end of `before` to that of `strip`, corners sharper than 45 degrees.
std::size_t sharp_corners(const Strip& before, const Strip& strip) {
  std::vector<FieldPoint> way{before.begin, before.end};
  way.insert(way.end(), strip.approach.begin(), strip.approach.end());
  way.insert(way.end(), {strip.begin, strip.end});
  const auto same = [](FieldPoint a, FieldPoint b) { return distance(a, b) < metres(1e-6); };
  way.erase(std::unique(way.begin(), way.end(), same), way.end());
  std::size_t sharp = 0;
  for (std::size_t i = 2; i < way.size(); ++i) {
    if (turn_rad(way[i - 1] - way[i - 2], way[i] - way[i - 1]) > std::numbers::pi / 4) ++sharp;
  }
  return sharp;
}

}  // namespace

double coverage_cost_m(const Coverage& coverage, Length swath, const AvoidanceSettings& avoidance,
                       Length turn_cost) {
  const auto& strips = coverage.route.strips;
  Length route{};
  std::size_t corners = 0;
  for (std::size_t i = 0; i < strips.size(); ++i) {
    route += distance(strips[i].begin, strips[i].end);
    if (i == 0) continue;
    route += approach_length(strips[i - 1], strips[i]);
    corners += sharp_corners(strips[i - 1], strips[i]);
  }
  route += 0.5 * static_cast<double>(corners) * turn_cost;
  const SprayedAreas& areas = coverage.sweep.value().areas;
  return avoidance.length_weight * route.base() +
         avoidance.area_weight * (areas.missed + areas.repeated).base() / swath.base();
}

LedOrEnded led_or_ended(const Field& field, Length swath, const AvoidanceSettings& avoidance,
                        Length turn_cost, const Covering& covering) {
  std::vector<std::size_t> tried = large_outlines(field, swath, avoidance.method);
  LedOrEnded best{tried, covering(tried)};
  double best_m = INFINITY;
  if (best.coverage) best_m = coverage_cost_m(*best.coverage, swath, avoidance, turn_cost);
  tried.resize(std::min(tried.size(), most_outlines_tried));
  for (const std::size_t outline : tried) {
    std::vector<std::size_t> ends_rows = best.ends_rows;
    std::erase(ends_rows, outline);
    LedOrEnded other{ends_rows, covering(ends_rows)};
    if (!other.coverage) continue;
    const double other_m = coverage_cost_m(*other.coverage, swath, avoidance, turn_cost);
    if (other_m >= best_m) continue;
    best = std::move(other);
    best_m = other_m;
  }
  return best;
}

}  // namespace furrow::planner
