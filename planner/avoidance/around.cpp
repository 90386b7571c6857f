#include "planner/avoidance/around.hpp"

#include "core/require.hpp"
#include "planner/avoidance/turns.hpp"
#include "planner/coverage/geos.hpp"
#include "planner/coverage/swath/inset.hpp"
#include "planner/coverage/swath/inside_paths.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace furrow::planner {
namespace {

constexpr double same_m = 1e-6;
constexpr double corner_room_m = 0.3;  // that a rounded corner may take of a way's clearance

PathM plane(const std::vector<FieldPoint>& line) {
  PathM path;
  for (const FieldPoint p : line) path.push_back({p.x.base(), p.y.base()});
  return path;
}

std::vector<FieldPoint> places(const PathM& path) {
  std::vector<FieldPoint> line;
  for (const PointM p : path) line.push_back(at_m(p.x, p.y));
  return line;
}

// Shortest ways between strips, around obstacles and inside the field.
class Ways {
 public:
  Ways(const Field& field, const SwathSettings& settings) : field_{field}, settings_{settings} {}

  // Both ends included; nothing if there is none.
  std::optional<PathM> shortest(PointM from, PointM to) {
    for (const double more_m : {corner_room_m, 0.0}) {
      for (const InsidePaths& part : parts(more_m)) {
        if (auto way = part.shortest(from, to)) return way;
      }
    }
    return std::nullopt;
  }

 private:
  // The flight area less obstacle circles that are wider by `more_m`.
  const std::vector<InsidePaths>& parts(double more_m) {
    std::vector<InsidePaths>& made = more_m > 0 ? wide_ : tight_;
    if (!made.empty()) return made;
    Field ground = field_;
    for (Obstacle& o : ground.obstacles) o.radius += metres(more_m);
    const auto land = field_land(ground, settings_.margin, settings_.hole_buffer,
                                 settings_.avoidance->safety + metres(tracking_room_m));
    if (!land) return made;
    for (const LandPart& part : moved(land->flight, land->origin)) made.emplace_back(part);
    return made;
  }

  const Field& field_;
  const SwathSettings& settings_;
  std::vector<InsidePaths> wide_, tight_;
};

double heading(FieldPoint from, FieldPoint to) {
  return std::atan2((to.y - from.y).base(), (to.x - from.x).base());
}

// Puts strips around obstacles back together, one after another.
class Joiner {
 public:
  Joiner(const Field& field, const SwathSettings& settings, const Room& room,
         AvoidanceRecord& record)
      : settings_{settings}, room_{room}, ways_{field, settings}, record_{record} {}

  void add(std::size_t row, const SwathStrip& straight, const AvoidedStrip& around) {
    const Length least = least_length(straight);
    std::vector<FieldPoint> given = straight.approach;
    bool is_first_of_part = given.empty();
    std::vector<FieldPoint> closed;  // flown with the valve closed since the last strip
    for (const Stretch& stretch : around.stretches) {
      if (!stretch.spraying) {
        closed = stretch.line;
        continue;
      }
      if (metres(length_m(plane(stretch.line))) < least) continue;
      std::vector<FieldPoint> approach;
      if (!closed.empty() && follows(closed.front()) && follows(closed.back(), stretch.line)) {
        approach = closed;
      } else if (!strips_.empty() && !is_first_of_part) {
        approach = joined(given, stretch.line);
      }
      append(stretch.line, straight.width, approach);
      rows_.resize(strips_.size(), row);
      closed.clear();
      given.clear();
      is_first_of_part = false;
    }
  }

  const std::vector<SwathStrip>& strips() const { return strips_; }
  const std::vector<std::size_t>& rows() const { return rows_; }

  // Two ends that no clear way inside the field joins.
  std::optional<std::pair<FieldPoint, FieldPoint>> gap() const { return gap_; }

 private:
  bool follows(FieldPoint place) const {
    return !strips_.empty() && distance(strips_.back().to, place) < metres(same_m);
  }
  static bool follows(FieldPoint place, const std::vector<FieldPoint>& line) {
    return distance(place, line.front()) < metres(same_m);
  }

  // Shorter stretches are not worth the way; a row that was so short is.
  Length least_length(const SwathStrip& straight) const {
    const Length whole = distance(straight.from, straight.to) - metres(same_m);
    return std::min(whole, std::max(settings_.min_strip, metres(0.5)));
  }

  // The way to a stretch from the strip before; `given` is how they were joined without obstacles.
  std::vector<FieldPoint> joined(const std::vector<FieldPoint>& given,
                                 const std::vector<FieldPoint>& line) {
    const FieldPoint from = strips_.back().to, to = line.front();
    if (distance(from, to) < metres(same_m)) return {from, to};
    if (auto turn = dubins(line)) return *turn;
    const bool is_given = !given.empty() && distance(given.front(), from) < metres(same_m) &&
                          distance(given.back(), to) < metres(same_m);
    if (is_given && room_.is_clear(plane(given))) return given;
    const PointM a{from.x.base(), from.y.base()}, b{to.x.base(), to.y.base()};
    if (const auto way = ways_.shortest(a, b)) return places(*way);
    if (room_.is_free({a, b})) return {from, to};
    // A strip that ends in the wedge between a circle and its polygon has ways that a turn finds.
    if (const auto turn = turn_to(line); turn && turn->is_inside) return turn->way;
    ++record_.unjoined;
    if (!gap_) gap_ = {from, to};
    return {from, to};
  }

  std::optional<Turn> turn_to(const std::vector<FieldPoint>& line) const {
    const SwathStrip& last = strips_.back();
    return strip_turn({last.to, heading(last.from, last.to)},
                      {line.front(), heading(line[0], line[1])}, settings_.avoidance->turn_radius,
                      room_);
  }

  // A turn of the aircraft's own radius, where it needs one and there is room inside.
  std::optional<std::vector<FieldPoint>> dubins(const std::vector<FieldPoint>& line) {
    if (!settings_.avoidance->dubins_turns) return std::nullopt;
    auto turn = turn_to(line);
    if (turn && turn->is_inside) {
      ++record_.turns;
      return turn->way;
    }
    ++record_.unturned;
    return std::nullopt;
  }

  void append(const std::vector<FieldPoint>& line, Length width,
              const std::vector<FieldPoint>& approach) {
    for (std::size_t i = 1; i < line.size(); ++i) {
      if (distance(line[i - 1], line[i]) < metres(same_m)) continue;
      strips_.push_back({line[i - 1], line[i], width, {}});
      // A leg begins where the one before ends.
      strips_.back().approach = i == 1 ? approach : std::vector{line[i - 1], line[i - 1]};
    }
  }

  const SwathSettings& settings_;
  const Room& room_;
  Ways ways_;
  AvoidanceRecord& record_;
  std::vector<SwathStrip> strips_;
  std::vector<std::size_t> rows_;  // of each strip
  std::optional<std::pair<FieldPoint, FieldPoint>> gap_;
};

std::vector<SprayedRun> runs_of(const std::vector<SwathStrip>& strips, PointM origin) {
  std::vector<SprayedRun> runs;
  for (std::size_t i = 0; i < strips.size(); ++i) {
    const PathM leg = plane({strips[i].from, strips[i].to});
    const bool goes_on = i > 0 && distance(strips[i - 1].to, strips[i].from) < metres(same_m) &&
                         strips[i - 1].width == strips[i].width;
    if (goes_on) {
      runs.back().path.push_back(leg[1] - origin);
    } else {
      runs.push_back({{leg[0] - origin, leg[1] - origin}, strips[i].width.base()});
    }
  }
  return runs;
}

// Lengths and areas of what the strips have become.
void measure(RowsAround& made, const FieldLand& land) {
  for (const SwathStrip& strip : made.strips) {
    made.sprayed += distance(strip.from, strip.to);
    made.route += metres(length_m(plane(strip.approach)));
  }
  made.route += made.sprayed;
  made.areas = sprayed_areas(runs_of(made.strips, land.origin), land.land);
}

PlanError cut_by_obstacles(const std::pair<FieldPoint, FieldPoint>& gap, Length safety) {
  const auto& [from, to] = gap;
  return {PlanFault::field_invalid,
          fmt::format("obstacles cut the field: no way leads from ({:.1f}, {:.1f}) to ({:.1f}, "
                      "{:.1f}) m with {} m to spare",
                      from.x.base(), from.y.base(), to.x.base(), to.y.base(), safety.base())};
}

// What rows overlap by on purpose is not what detours spray twice.
std::vector<StraightStrip> straight_strips(const std::vector<SwathStrip>& rows, Length overlap) {
  std::vector<StraightStrip> strips;
  strips.reserve(rows.size());
  for (const SwathStrip& s : rows) strips.push_back({s.from, s.to, s.width - overlap});
  return strips;
}

Expected<Room, PlanError> planned_room(const Field& field, const SwathSettings& settings) {
  return room_of(field, settings.margin, settings.hole_buffer,
                 settings.avoidance->safety + metres(tracking_room_m),
                 settings.avoidance->ends_rows);
}

}  // namespace

Expected<AvoidanceFigures, PlanError> half_circles(const Field& field,
                                                   const std::vector<StraightStrip>& rows,
                                                   const SwathSettings& settings) {
  require(settings.avoidance.has_value(), "obstacles are flown around by settings");
  const auto room = planned_room(field, settings);
  if (!room) return Unexpected{room.error()};
  AvoidanceSettings classic = *settings.avoidance;
  classic.method = AvoidanceMethod::classic;
  return plan_avoidance(rows, *room, classic).figures;
}

Expected<RowsAround, PlanError> rows_around(const Field& field, const std::vector<SwathStrip>& rows,
                                            const SwathSettings& settings) {
  require(settings.avoidance.has_value(), "obstacles are flown around by settings");
  const auto land = field_land(field, settings.margin, settings.hole_buffer);
  if (!land) return Unexpected{land.error()};
  const auto room = planned_room(field, settings);
  if (!room) return Unexpected{room.error()};

  auto strips = straight_strips(rows, settings.row_overlap.value_or(Length{}));
  const AvoidancePlan plan = plan_avoidance(strips, *room, *settings.avoidance);
  RowsAround made{.strips = {},
                  .rows = {},
                  .areas = {},
                  .sprayed = {},
                  .route = {},
                  .record = {.planned = plan.figures,
                             .straight = std::move(strips),
                             .safety = settings.avoidance->safety,
                             .ended = settings.avoidance->ends_rows.size()}};
  Joiner joiner{field, settings, *room, made.record};
  for (std::size_t i = 0; i < plan.strips.size(); ++i) joiner.add(i, rows[i], plan.strips[i]);
  if (const auto gap = joiner.gap()) {
    return Unexpected{cut_by_obstacles(*gap, settings.avoidance->safety)};
  }
  made.strips = joiner.strips();
  made.rows = joiner.rows();
  if (made.strips.empty()) {
    return Unexpected{
        PlanError{PlanFault::nothing_to_spray, "obstacles leave no strip that can be flown"}};
  }
  made.strips.front().approach.clear();
  measure(made, *land);
  return made;
}

Expected<SwathCoverage, PlanError> coverage_around(const Field& field, Length swath,
                                                   const SwathSettings& settings,
                                                   std::optional<AvoidanceRecord>& record) {
  SwathSettings straight = settings;
  straight.safety = settings.avoidance->safety;
  straight.avoidance.reset();
  auto made =
      swath_coverage(without_led_around(field, settings.avoidance->ends_rows), swath, straight);
  if (!made) return made;
  auto around = rows_around(field, made->strips, settings);
  if (!around) return Unexpected{around.error()};
  record = around->record;
  made->strips = std::move(around->strips);
  made->areas = around->areas;
  made->sprayed = around->sprayed;
  made->route = around->route;
  return made;
}

}  // namespace furrow::planner
