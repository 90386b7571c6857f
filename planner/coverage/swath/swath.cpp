#include "planner/coverage/swath/swath.hpp"

#include "planner/coverage/geos.hpp"
#include "planner/coverage/swath/finish.hpp"
#include "planner/coverage/swath/headland.hpp"
#include "planner/coverage/swath/inset.hpp"
#include "planner/coverage/swath/part_plan.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <utility>

namespace furrow::planner {
namespace {

constexpr double most_rows = 200'000;

RowFrame frame_of_heading(double heading_deg) {
  const double angle = heading_deg * std::numbers::pi / 180;
  const auto snapped = [](double v) { return std::abs(v) < 1e-15 ? 0.0 : v; };
  return {snapped(std::sin(angle)), snapped(std::cos(angle))};
}

double heading_of(RowFrame frame) {
  const double degrees = std::atan2(frame.cosine, frame.sine) * 180 / std::numbers::pi;
  const double half_turn = std::fmod(degrees + 360, 180);
  return half_turn;
}

// The land that strips in `flight` can reach: where flight keeps off the edges, what lies within
// half a swath of it.
LandParts reachable(const LandPart& flight, const FieldLand& field, double swath_m) {
  const bool drawn_in = area_m2(field.flight) < (1 - 1e-9) * area_m2(field.land);
  if (!drawn_in) return field.flight.size() == 1 ? field.land : LandParts{flight};
  return subtracted(field.land, subtracted(field.land, offset({flight}, swath_m / 2)));
}

// Around the part by headland passes, then rows on what is within.
PartPlan plan_headland(const LandPart& flight, const FieldLand& field, const InsidePaths& paths,
                       std::optional<RowDirection> direction, const PlanRule& rule) {
  const SwathSettings& s = rule.settings;
  const Headland head =
      headland(flight, rule.swath_m, rule.margin_m, s.headland_passes, s.headland_turn);
  PartPlan plan{.groups = head.rounds, .order = {}};
  for (const LandPart& inner : head.inner) {
    plan = direction
               ? plan_one_direction(inner, flight, field.land, paths, *direction, rule, plan.groups)
               : ranked_plans(inner, flight, field.land, paths, rule, plan.groups).front();
  }
  if (head.inner.empty()) plan.order = strip_order(plan.groups, paths, rule.start);
  return plan;
}

// The plans of one part, cheapest first; what finishing them adds is not counted yet.
std::vector<PartPlan> plans_of(const LandPart& flight, const FieldLand& field,
                               const InsidePaths& paths, std::optional<RowDirection> direction,
                               const PlanRule& rule) {
  if (rule.settings.headland_passes > 0) {
    return {plan_headland(flight, field, paths, direction, rule)};
  }
  if (direction) {
    return {plan_one_direction(flight, flight, field.land, paths, *direction, rule, {})};
  }
  return ranked_plans(flight, flight, field.land, paths, rule, {});
}

PartPlan plan_part(const LandPart& flight, const FieldLand& field,
                   std::optional<RowDirection> direction, const PlanRule& rule) {
  const InsidePaths paths{flight};
  const LandParts here = rule.settings.edges == EdgeMode::cover_all
                             ? reachable(flight, field, rule.swath_m)
                             : field.land;
  return cheapest_finished(plans_of(flight, field, paths, direction, rule), flight, here, paths,
                           rule);
}

struct Laid {
  std::vector<OrderedStrip> strips;
  double route_m = 0, bound_m = 0, dropped_m2 = 0;
  RowFrame direction{1, 0};
  bool exact = true;
};

void lay(Laid& laid, PartPlan&& plan) {
  for (OrderedStrip& strip : plan.order.strips) laid.strips.push_back(std::move(strip));
  laid.route_m += plan.order.route_m;
  laid.bound_m += plan.order.bound_m;
  laid.dropped_m2 += plan.dropped_m2;
  laid.exact = laid.exact && (plan.order.exact || plan.order.strips.empty());
}

FieldPoint field_point(PointM p, PointM origin) { return at_m(p.x + origin.x, p.y + origin.y); }
PointM plane_point(FieldPoint p, PointM origin) { return PointM{p.x.base(), p.y.base()} - origin; }

SwathCoverage coverage_of(const Laid& laid, const FieldLand& field) {
  SwathCoverage made{.strips = {},
                     .direction_deg = heading_of(laid.direction),
                     .parts = field.flight.size(),
                     .areas = sprayed_areas(runs_of(laid.strips), field.land),
                     .dropped = square_metres(laid.dropped_m2),
                     .sprayed = {},
                     .route = metres(laid.route_m),
                     .order_bound = metres(laid.bound_m),
                     .order_exact = laid.exact};
  for (const OrderedStrip& strip : laid.strips) {
    SwathStrip out{field_point(strip.strip.a, field.origin),
                   field_point(strip.strip.b, field.origin),
                   metres(2 * strip.strip.half_width_m),
                   {}};
    for (const PointM p : strip.approach) out.approach.push_back(field_point(p, field.origin));
    made.sprayed += metres(norm(strip.strip.b - strip.strip.a));
    made.strips.push_back(std::move(out));
  }
  return made;
}

std::optional<PlanError> too_many_rows(const LandParts& land, double swath_m) {
  double reach_m = 0;
  for (const LandPart& part : land) {
    for (const PointM p : part.outer) reach_m = std::max(reach_m, norm(p));
  }
  if (2 * reach_m / swath_m <= most_rows) return std::nullopt;
  return PlanError{PlanFault::too_many_rows,
                   fmt::format("a field of {:.0f} m has more than {:.0f} rows of {} m", 2 * reach_m,
                               most_rows, swath_m)};
}

// The part nearest to `place`, taken out of `left`.
std::size_t take_nearest(std::vector<std::size_t>& left, const LandParts& parts, PointM place) {
  const auto away_m = [&](std::size_t part) {
    double best = INFINITY;
    for (const PointM p : parts[part].outer) best = std::min(best, norm(p - place));
    return best;
  };
  const auto nearest =
      std::min_element(left.begin(), left.end(),
                       [&](std::size_t a, std::size_t b) { return away_m(a) < away_m(b); });
  const std::size_t found = *nearest;
  left.erase(nearest);
  return found;
}

Laid lay_parts(const FieldLand& field, std::optional<RowDirection> direction, PlanRule rule) {
  Laid laid;
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < field.flight.size(); ++i) left.push_back(i);
  double largest_m2 = 0;
  while (!left.empty()) {
    const std::size_t next =
        rule.start ? take_nearest(left, field.flight, *rule.start) : left.front();
    if (!rule.start) left.erase(left.begin());
    PartPlan plan = plan_part(field.flight[next], field, direction, rule);
    if (area_m2(field.flight[next]) > largest_m2) {
      largest_m2 = area_m2(field.flight[next]);
      laid.direction = plan.direction;
    }
    lay(laid, std::move(plan));
    if (!laid.strips.empty()) rule.start = laid.strips.back().strip.b;
  }
  return laid;
}

// Without the places less than `least` from the one before, but for the last.
std::vector<FieldPoint> steadied(const std::vector<FieldPoint>& path, Length least) {
  std::vector<FieldPoint> made{path.front()};
  for (const FieldPoint p : path) {
    if (distance(p, made.back()) >= least) made.push_back(p);
  }
  if (made.back() == path.back()) return made;
  if (made.size() > 1 && distance(path.back(), made.back()) < least) made.pop_back();
  made.push_back(path.back());
  return made;
}

std::vector<SprayedRun> runs_of(const std::vector<std::vector<FlownPlace>>& tracks, Length swath,
                                PointM origin) {
  std::vector<SprayedRun> runs;
  for (const BoomRun& run : boom_runs(swath, tracks)) {
    runs.push_back({{}, run.width.base()});
    for (const FieldPoint p : run.path) runs.back().path.push_back(plane_point(p, origin));
  }
  return runs;
}

}  // namespace

Expected<SwathCoverage, PlanError> swath_coverage(const Field& field, Length swath,
                                                  const SwathSettings& settings) {
  require(swath > Length{}, "a swath is wider than 0");
  require(settings.min_strip >= Length{} && settings.spray_margin >= Length{} &&
              settings.headland_passes >= 0 && settings.turn_cost >= Length{},
          "least strips, headland passes and turn costs are at least 0");
  const Length overlap = settings.row_overlap.value_or(Length{});
  require(overlap >= Length{} && overlap <= 0.5 * swath, "rows overlap by half a swath at most");
  // Bands narrower by the overlap are laid edge to edge, then widened to both sides.
  const Length kept =
      settings.edges == EdgeMode::stay_inside ? settings.spray_margin + 0.5 * overlap : Length{};
  const Length margin = std::max(settings.margin, kept);
  const auto land =
      field_land(field, margin, settings.hole_buffer, planned_clearance(settings.safety));
  if (!land) return Unexpected{land.error()};
  // Rows are laid on what may be sprayed; what they cover is judged on all of the land.
  FieldLand sprayable = *land;
  sprayable.land = offset(land->land, -kept.base());
  if (auto error = too_many_rows(land->land, (swath - overlap).base())) return Unexpected{*error};

  PlanRule rule{(swath - overlap).base(), swath.base(), (margin - kept).base(), settings,
                std::nullopt};
  if (settings.near) rule.start = plane_point(*settings.near, land->origin);
  std::optional<RowDirection> direction;
  if (settings.direction_deg) {
    direction = RowDirection{frame_of_heading(*settings.direction_deg), true};
  } else if (!settings.cells_may_differ) {
    direction = ranked_directions(land->flight, rule, 1).front();
  }
  Laid laid = lay_parts(sprayable, direction, rule);
  if (laid.strips.empty()) {
    return Unexpected{PlanError{PlanFault::nothing_to_spray,
                                fmt::format("no strip of {} m swath and at least {} m fits",
                                            swath.base(), settings.min_strip.base())}};
  }
  for (OrderedStrip& strip : laid.strips) strip.strip.half_width_m += overlap.base() / 2;
  return coverage_of(laid, *land);
}

std::vector<BoomRun> boom_runs(Length swath, const std::vector<std::vector<FlownPlace>>& tracks) {
  std::vector<BoomRun> runs;
  for (const std::vector<FlownPlace>& track : tracks) {
    bool open = false;
    for (std::size_t i = 1; i < track.size(); ++i) {
      const FlownPlace& place = track[i];
      const bool was_open = std::exchange(open, place.spraying);
      if (!open) continue;
      const Length width = place.width == Length{} ? swath : place.width;
      if (!was_open || runs.back().width != width) runs.push_back({{track[i - 1].at}, width});
      runs.back().path.push_back(place.at);
    }
  }
  for (BoomRun& run : runs) run.path = steadied(run.path, 0.5 * swath);
  return runs;
}

Expected<FlownCoverage, PlanError> flown_coverage(
    const Field& field, Length swath, const std::vector<std::vector<FlownPlace>>& tracks) {
  const auto land = field_land(field, Length{}, Length{});
  if (!land) return Unexpected{land.error()};
  std::vector<PathM> paths;
  for (const std::vector<FlownPlace>& track : tracks) {
    PathM& path = paths.emplace_back();
    for (const FlownPlace& place : track) path.push_back(plane_point(place.at, land->origin));
  }
  return FlownCoverage{sprayed_areas(runs_of(tracks, swath, land->origin), land->land),
                       metres(length_outside_m(paths, offset(land->land, EdgeGrid::touch_m * 10)))};
}

Expected<std::vector<Ring>, PlanError> left_out(
    const Field& field, Length swath, const std::vector<std::vector<FlownPlace>>& tracks) {
  const auto land = field_land(field, Length{}, Length{});
  if (!land) return Unexpected{land.error()};
  std::vector<Ring> rings;
  const auto add = [&](const RingM& ring) {
    Ring& made = rings.emplace_back();
    for (const PointM p : ring) made.push_back(field_point(p, land->origin));
  };
  for (const LandPart& part : missed_land(runs_of(tracks, swath, land->origin), land->land)) {
    add(part.outer);
    for (const RingM& island : part.holes) add(island);
  }
  return rings;
}

Expected<Length, PlanError> length_outside(const Field& field,
                                           const std::vector<std::vector<FieldPoint>>& ways,
                                           Length tolerance) {
  require(tolerance > Length{}, "a way along an edge is not outside");
  const auto land = field_land(field, Length{}, Length{});
  if (!land) return Unexpected{land.error()};
  std::vector<PathM> paths;
  for (const std::vector<FieldPoint>& way : ways) {
    PathM& path = paths.emplace_back();
    for (const FieldPoint p : way) path.push_back(plane_point(p, land->origin));
  }
  return metres(length_outside_m(paths, offset(land->land, tolerance.base())));
}

}  // namespace furrow::planner
