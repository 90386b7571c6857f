#include "planner/coverage/cover.hpp"

#include "core/corner.hpp"
#include "planner/avoidance/walk_around.hpp"
#include "planner/coverage/swath/swath_route.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace furrow::planner {
namespace {

Expected<Coverage, PlanError> walked(const Field& field, Length swath,
                                     const CoverageSettings& settings) {
  auto route = coverage_route(field, swath, settings);
  if (!route) return Unexpected{route.error()};
  std::vector<std::size_t> leaps;
  for (std::size_t i = 1; i < route->strips.size(); ++i) {
    if (!route->strips[i].continues) leaps.push_back(i);
  }
  return Coverage{std::move(*route), settings.work_direction_deg, std::move(leaps), std::nullopt};
}

Expected<Coverage, PlanError> walked_around(const Field& field, Length swath,
                                            const CoverageSettings& settings) {
  auto walk = walk_around(field, swath, settings);
  if (!walk) return Unexpected{walk.error()};
  const RowsAround& rows = walk->rows;
  const SweepFigures figures{.areas = rows.areas,
                             .dropped = {},
                             .sprayed = rows.sprayed,
                             .route = rows.route,
                             .order_bound = rows.sprayed,
                             .order_exact = false,
                             .parts = 1,
                             .avoidance = rows.record};
  return Coverage{std::move(walk->route), settings.work_direction_deg, std::move(walk->leaps),
                  figures};
}

Expected<Coverage, PlanError> swept(const Field& field, Length swath,
                                    const SwathSettings& settings) {
  std::optional<AvoidanceRecord> record;
  const auto swaths = settings.avoidance ? coverage_around(field, swath, settings, record)
                                         : swath_coverage(field, swath, settings);
  if (!swaths) return Unexpected{swaths.error()};
  std::vector<std::size_t> leaps;
  for (std::size_t i = 1; i < swaths->strips.size(); ++i) {
    if (swaths->strips[i].approach.empty()) leaps.push_back(i);
  }
  return Coverage{swath_route(*swaths, swath), swaths->direction_deg, std::move(leaps),
                  SweepFigures{.areas = swaths->areas,
                               .dropped = swaths->dropped,
                               .sprayed = swaths->sprayed,
                               .route = swaths->route,
                               .order_bound = swaths->order_bound,
                               .order_exact = swaths->order_exact,
                               .parts = static_cast<std::uint32_t>(swaths->parts),
                               .avoidance = record}};
}

Expected<Coverage, PlanError> covered(const Field& field, Length swath,
                                      const CoverageModel& model) {
  if (const auto* grid = std::get_if<CoverageSettings>(&model)) {
    return grid->avoidance ? walked_around(field, swath, *grid) : walked(field, swath, *grid);
  }
  return swept(field, swath, std::get<SwathSettings>(model));
}

double ground_m2(const Obstacle& o) {
  RingM ring;
  for (const FieldPoint p : o.outline) ring.push_back({p.x.base(), p.y.base()});
  return std::abs(signed_area_m2(ring));
}

// By number, that of the least ground first.
std::vector<std::size_t> large_outlines(const Field& field, Length swath) {
  std::vector<std::size_t> large;
  const auto& all = field.obstacles;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!all[i].outline.empty() && all[i].radius > 2.0 * swath) large.push_back(i);
  }
  std::stable_sort(large.begin(), large.end(), [&](std::size_t a, std::size_t b) {
    return ground_m2(all[a]) < ground_m2(all[b]);
  });
  return large;
}

CoverageModel with_ends(CoverageModel model, const std::vector<std::size_t>& ends_rows) {
  std::visit([&](auto& settings) { settings.avoidance->ends_rows = ends_rows; }, model);
  return model;
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

double coverage_cost_m(const Coverage& coverage, Length swath, const AvoidanceSettings& avoidance) {
  const auto& strips = coverage.route.strips;
  Length route{};
  std::size_t corners = 0;
  for (std::size_t i = 0; i < strips.size(); ++i) {
    route += distance(strips[i].begin, strips[i].end);
    if (i == 0) continue;
    route += approach_length(strips[i - 1], strips[i]);
    corners += sharp_corners(strips[i - 1], strips[i]);
  }
  route += 0.5 * static_cast<double>(corners) * SwathSettings{}.turn_cost;
  const SprayedAreas& areas = coverage.sweep.value().areas;
  return avoidance.length_weight * route.base() +
         avoidance.area_weight * (areas.missed + areas.repeated).base() / swath.base();
}

const std::optional<AvoidanceSettings>& avoidance_of(const CoverageModel& model) {
  return std::visit(
      [](const auto& settings) -> const std::optional<AvoidanceSettings>& {
        return settings.avoidance;
      },
      model);
}

Length safety_of(const CoverageModel& model) {
  if (const auto& avoidance = avoidance_of(model)) return avoidance->safety;
  return std::visit([](const auto& settings) { return settings.safety; }, model);
}

Expected<Coverage, PlanError> cover(const Field& field, Length swath, const CoverageModel& model) {
  constexpr std::size_t most_tried = 8;
  const auto& avoidance = avoidance_of(model);
  if (!avoidance) return covered(field, swath, model);
  const std::vector<std::size_t> large = large_outlines(field, swath);
  std::vector<std::size_t> ends_rows = large;
  auto best = covered(field, swath, with_ends(model, ends_rows));
  for (std::size_t i = 0; i < std::min(large.size(), most_tried); ++i) {
    std::vector<std::size_t> fewer = ends_rows;
    std::erase(fewer, large[i]);
    auto other = covered(field, swath, with_ends(model, fewer));
    const auto cost_m = [&](const Coverage& c) { return coverage_cost_m(c, swath, *avoidance); };
    if (!other || (best && cost_m(*best) <= cost_m(*other))) continue;
    best = std::move(other);
    ends_rows = std::move(fewer);
  }
  return best;
}

}  // namespace furrow::planner
