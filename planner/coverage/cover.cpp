#include "planner/coverage/cover.hpp"

#include "planner/avoidance/walk_around.hpp"
#include "planner/coverage/led_or_ended.hpp"
#include "planner/coverage/swath/swath_route.hpp"

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

Covering ending_rows(const Field& field, Length swath, const CoverageModel& model) {
  return [&field, swath, model](const std::vector<std::size_t>& ends_rows) {
    CoverageModel ending = model;
    std::visit([&](auto& settings) { settings.avoidance->ends_rows = ends_rows; }, ending);
    return covered(field, swath, ending);
  };
}

SwathSettings as_rows(const CoverageModel& model) {
  if (const auto* grid = std::get_if<CoverageSettings>(&model)) return as_rows(*grid);
  return std::get<SwathSettings>(model);
}

Expected<Coverage, PlanError> with_half_circles(LedOrEnded chosen, const Field& field,
                                                const CoverageModel& model) {
  if (!chosen.coverage) return chosen.coverage;
  SwathSettings settings = as_rows(model);
  settings.avoidance->ends_rows = chosen.ends_rows;
  AvoidanceRecord& record = *chosen.coverage->sweep.value().avoidance;
  const auto classic = half_circles(field, record.straight, settings);
  if (!classic) return Unexpected{classic.error()};
  record.classic = *classic;
  return std::move(chosen.coverage);
}

}  // namespace

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
  if (!avoidance_of(model)) return covered(field, swath, model);
  const SwathSettings rows = as_rows(model);
  auto chosen =
      led_or_ended(field, swath, *rows.avoidance, rows.turn_cost, ending_rows(field, swath, model));
  return with_half_circles(std::move(chosen), field, model);
}

}  // namespace furrow::planner
