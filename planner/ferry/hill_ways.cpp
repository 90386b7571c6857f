#include "planner/ferry/hill_ways.hpp"

#include "core/random.hpp"
#include "planner/ferry/turns.hpp"
#include "planner/routes/drawn.hpp"
#include "planner/routes/route_cost.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace furrow::planner {
namespace {

constexpr double anchor_pitch_m = 100, square_m = 20;
constexpr double at_stand_m = 3;    // a way begins where an aircraft has come to stand
constexpr double least_gain_s = 2;  // there and back, for which a way is left
constexpr double room_share = 0.6;  // of the distance, on each side of it
constexpr double room_m = 60;       // and on each side besides
constexpr double headroom_m = 60;   // over the highest ground where there is no ceiling
constexpr double spare_m = 1;       // stand and anchor are so far above the least height
constexpr double first_step_m = 16, last_step_m = 4;
constexpr int most_moves = 3;               // of one point one way, of each length
constexpr std::size_t most_points = 3;      // that a way leads past
constexpr std::size_t most_ways = 200'000;  // kept

// Straight from point to point.
double chain_m(FieldPoint from, std::span<const FieldPoint> points, FieldPoint to) {
  return distance(from, points.front()).base() + way_length(points).base() +
         distance(points.back(), to).base();
}

// Few enough of those that a curve bends at, in plan.
std::vector<FieldPoint> bends(std::vector<WayPoint> curve) {
  for (WayPoint& p : curve) p.z_m = 0;
  std::vector<WayPoint> kept;
  for (double off_m = 4;; off_m *= 1.5) {
    kept = drawn(curve, off_m);
    if (kept.size() <= most_points) break;
  }
  std::vector<FieldPoint> made;
  made.reserve(kept.size());
  for (const WayPoint p : kept) made.push_back(at_m(p.x_m, p.y_m));
  return made;
}

}  // namespace

HillWays::HillWays(FerryMap land, std::shared_ptr<const Relief> relief, const RouteSettings& search,
                   std::span<const FieldPoint> stands)
    : land_{std::move(land)},
      relief_{std::move(relief)},
      search_{search},
      stands_{stands.begin(), stands.end()},
      highest_m_{relief_->highest_ferry_m()},
      may_be_over_{relief_->rule().ceiling && highest_m_ > relief_->rule().ceiling->base()} {
  const std::vector<float>& ground = relief_->surface().raster().heights_m;
  lowest_m_ = *std::min_element(ground.begin(), ground.end());
}

std::size_t HillWays::stand_at(FieldPoint place) const {
  const auto near = std::find_if(stands_.begin(), stands_.end(), [&](FieldPoint stand) {
    return distance(stand, place).base() <= at_stand_m;
  });
  return static_cast<std::size_t>(near - stands_.begin());
}

HillWays::Goal HillWays::goal(std::size_t stand, FieldPoint to, const Vehicle& v) {
  return {stand,
          {v.ferry_speed.base(), planned_acceleration(v).base(), v.swath.base(),
           v.min_turn_radius.base()},
          to.x.base(),
          to.y.base()};
}

std::vector<FieldPoint> HillWays::way(FieldPoint from, FieldPoint to, const Vehicle& v) const {
  if (const std::size_t stand = stand_at(from); stand < stands_.size()) {
    return out(from, stand, to, v);
  }
  const std::size_t stand = stand_at(to);
  if (stand == stands_.size() || found(stand, from, v).points.empty()) return land_.way(from, to);
  Places way = out(to, stand, from, v);
  std::reverse(way.begin(), way.end());
  return way;
}

HillWays::Places HillWays::out(FieldPoint from, std::size_t stand, FieldPoint to,
                               const Vehicle& v) const {
  const Found& known = found(stand, to, v);
  return from == stands_[stand] && !known.points.empty() ? known.way : past(from, known.points, to);
}

// Over the land from one to the next.
HillWays::Places HillWays::past(FieldPoint from, std::span<const FieldPoint> points,
                                FieldPoint to) const {
  Places made{from};
  const auto go_on = [&](FieldPoint next) {
    const Places leg = land_.way(made.back(), next);
    made.insert(made.end(), leg.begin() + 1, leg.end());
  };
  for (const FieldPoint point : points) go_on(point);
  go_on(to);
  return made;
}

HillWays::RoundTrip HillWays::flown(const Places& way, const Vehicle& v) const {
  const HeightRule& rule = relief_->rule();
  const Places back{way.rbegin(), way.rend()};
  const AirWay there = relief_->ferry(std::span{way}, v.ferry_speed, Length{});
  RoundTrip trip{
      .over_m = 0,
      .out_s = relief_->cost(way.front(), there).time_s,
      .back_s = relief_->cost(way.back(), relief_->ferry(std::span{back}, v.ferry_speed, Length{}))
                    .time_s,
      .turns_s = 0};
  for (std::size_t i = 1; i + 1 < way.size(); ++i) {
    trip.turns_s += turn_loss_s(way[i - 1], way[i], way[i + 1], Corner::cut, v);
  }
  if (rule.ceiling) {
    const double most_m = (*rule.ceiling - (rule.layers - 1.0) * rule.layer).base();
    for (const AirLeg& leg : there.legs)
      trip.over_m = std::max(trip.over_m, leg.altitude_m - most_m);
  }
  return trip;
}

const HillWays::Found& HillWays::found(std::size_t stand, FieldPoint to, const Vehicle& v) const {
  const Goal key = goal(stand, to, v);
  if (const auto known = found_.find(key); known != found_.end()) return known->second;
  if (found_.size() >= most_ways) found_.clear();
  return found_.emplace(key, best(stand, to, v)).first->second;
}

// Chosen for the middle of a square; taken where it serves the place itself.
HillWays::Found HillWays::best(std::size_t stand, FieldPoint to, const Vehicle& v) const {
  const Places& points = squared(stand, to, v);
  if (points.empty() && !may_be_over_) return {};
  std::vector<Choice> one;
  if (!points.empty()) one.push_back(choice(stand, points, to));
  Found made = chosen(stand, to, std::move(one), v);
  if (made.over_m > 0) made = chosen(stand, to, choices(stand, to, v), v);
  return made;
}

const HillWays::Places& HillWays::squared(std::size_t stand, FieldPoint to,
                                          const Vehicle& v) const {
  const auto middle = [](double at_m) { return (std::floor(at_m / square_m) + 0.5) * square_m; };
  const FieldPoint place = at_m(middle(to.x.base()), middle(to.y.base()));
  const auto [known, is_new] = squared_.try_emplace(goal(stand, place, v));
  if (is_new && !is_quick(stand, place, v)) {
    known->second = chosen(stand, place, choices(stand, place, v), v).points;
  }
  return known->second;
}

// The first that is best; none of `choices` where the shortest is.
HillWays::Found HillWays::chosen(std::size_t stand, FieldPoint to, std::vector<Choice> choices,
                                 const Vehicle& v) const {
  const FieldPoint from = stands_[stand];
  const RoundTrip base = flown(land_.way(from, to), v);
  Found made{.points = {}, .way = {}, .over_m = base.over_m};
  RoundTrip least = base;
  for (Choice& choice : choices) {
    const double gain_s = made.points.empty() ? least_gain_s : 0;
    const double level_s = 2 * choice.least_m / v.ferry_speed.base();
    if (least.over_m == 0 && level_s >= least.both_s() - gain_s) break;
    Places way = past(from, choice.points, to);
    const RoundTrip trip = flown(way, v);
    const bool is_slower = trip.out_s + trip.turns_s > base.out_s + base.turns_s ||
                           trip.back_s + trip.turns_s > base.back_s + base.turns_s;
    if (base.over_m == 0 && is_slower) continue;
    if (!trip.beats(least, gain_s)) continue;
    made = {std::move(choice.points), std::move(way), trip.over_m};
    least = trip;
  }
  return made;
}

// Whether no way is quicker than the shortest.
bool HillWays::is_quick(std::size_t stand, FieldPoint to, const Vehicle& v) const {
  constexpr double rounding = 1 + 1e-9;
  const Places shortest = land_.way(stands_[stand], to);
  const RoundTrip trip = flown(shortest, v);
  const double level_s = 2 * way_length(shortest).base() / v.ferry_speed.base();
  return trip.over_m == 0 && trip.out_s + trip.back_s <= rounding * level_s;
}

HillWays::Choice HillWays::choice(std::size_t stand, Places points, FieldPoint to) const {
  const double least_m = chain_m(stands_[stand], points, to);
  return {std::move(points), least_m};
}

// Past the points of the ways to the anchors around a place, and past all but
// their last; shortest first.
std::vector<HillWays::Choice> HillWays::choices(std::size_t stand, FieldPoint to,
                                                const Vehicle& v) const {
  std::vector<Choice> made;
  const double i = std::floor(to.x.base() / anchor_pitch_m);
  const double j = std::floor(to.y.base() / anchor_pitch_m);
  for (const double di : {0.0, 1.0}) {
    for (const double dj : {0.0, 1.0}) {
      const FieldPoint anchor = at_m((i + di) * anchor_pitch_m, (j + dj) * anchor_pitch_m);
      const Places& points = anchored(stand, anchor, v);
      if (!points.empty()) made.push_back(choice(stand, points, to));
      if (points.size() > 1) {
        made.push_back(choice(stand, {points.begin(), points.end() - 1}, to));
      }
    }
  }
  std::stable_sort(made.begin(), made.end(),
                   [](const Choice& a, const Choice& b) { return a.least_m < b.least_m; });
  return made;
}

const HillWays::Places& HillWays::anchored(std::size_t stand, FieldPoint anchor,
                                           const Vehicle& v) const {
  const auto [known, is_new] = anchored_.try_emplace(goal(stand, anchor, v));
  if (is_new) known->second = searched(stand, anchor, v);
  return known->second;
}

HillWays::Places HillWays::searched(std::size_t stand, FieldPoint anchor, const Vehicle& v) const {
  const FieldPoint from = stands_[stand];
  if (is_quick(stand, anchor, v)) return {};
  const Scene air = scene(from, anchor, v);
  RouteSettings settings = search_;
  settings.seed =
      seed_for(search_.seed, {stand, mixed(std::bit_cast<std::uint64_t>(anchor.x.base())),
                              std::bit_cast<std::uint64_t>(anchor.y.base())});
  const RouteSearch route = search_route(air, settings);
  Places points = bends(planner::flown(air, route.best.genes));
  std::erase_if(points, [&](FieldPoint p) { return !land_.is_open(p); });
  return settled(from, std::move(points), anchor, v);
}

// Each point moved while that makes the way quicker.
HillWays::Places HillWays::settled(FieldPoint stand, Places points, FieldPoint to,
                                   const Vehicle& v) const {
  RoundTrip least = flown(past(stand, points, to), v);
  const auto improves = [&](FieldPoint& point, FieldVector step) {
    const FieldPoint before = point;
    point = before + step;
    const double least_s = 2 * chain_m(stand, points, to) / v.ferry_speed.base();
    if ((least.over_m > 0 || least_s < least.both_s()) && land_.is_open(point)) {
      const RoundTrip trip = flown(past(stand, points, to), v);
      if (trip.beats(least, 0)) {
        least = trip;
        return true;
      }
    }
    point = before;
    return false;
  };
  for (double step_m = first_step_m; step_m >= last_step_m; step_m /= 2) {
    const Length step = metres(step_m), none{};
    for (FieldPoint& point : points) {
      for (const FieldVector move : {FieldVector{step, none}, FieldVector{-step, none},
                                     FieldVector{none, step}, FieldVector{none, -step}}) {
        for (int times = 0; times < most_moves; ++times) {
          if (!improves(point, move)) break;
        }
      }
    }
  }
  return points;
}

Scene HillWays::scene(FieldPoint stand, FieldPoint to, const Vehicle& v) const {
  const HeightRule& rule = relief_->rule();
  const double room = room_share * distance(stand, to).base() + room_m;
  const auto [least_x, most_x] = std::minmax({stand.x.base(), to.x.base()});
  const auto [least_y, most_y] = std::minmax({stand.y.base(), to.y.base()});
  Scene made{.surface = relief_->surface(),
             .low = {least_x - room, least_y - room, lowest_m_},
             .high = {most_x + room, most_y + room, highest_m_ + headroom_m},
             .keep_out = relief_->keep_out(),
             .clearance_m = rule.clearance.base(),
             .start = {},
             .goal = {},
             .steepest_climb = (std::min(rule.climb, rule.descent) / v.ferry_speed)};
  if (rule.ceiling) {
    const Length most = *rule.ceiling - (rule.layers - 1.0) * rule.layer;
    made.high.z_m = std::max(most.base(), made.low.z_m + 1);
  }
  const auto over = [&](FieldPoint p) {
    const double z_m = made.surface.height(p).base() + kept_m(made) + spare_m;
    return WayPoint{p.x.base(), p.y.base(), z_m};
  };
  made.start = over(stand);
  made.goal = over(to);
  return made;
}

}  // namespace furrow::planner
