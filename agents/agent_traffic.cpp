#include "agents/agent_node.hpp"
#include "agents/control_clock.hpp"
#include "agents/guidance/coming_track.hpp"

#include <algorithm>
#include <utility>

namespace furrow::agents {
namespace {

constexpr double answer_s = 3.0;  // in which a way is answered before it must brake
constexpr Duration longest_lead{4'000'000'000};

}  // namespace

const planner::HeightRule& AgentNode::height_rule() const {
  const planner::Relief* relief = settings_.ferries.relief();
  return relief == nullptr ? settings_.airspace->climbs : relief->rule();
}

SortieRoute AgentNode::lay(Xy from_m, std::span<const Piece> pieces,
                           std::optional<Length> begins) const {
  SortieRoute route = sortie_route(from_m, pieces, xy_m(home_.position), vehicle_,
                                   settings_.ferries, around_, begins);
  if (settings_.airspace && settings_.ferries.relief() == nullptr) {
    lift_ferries(route, settings_.airspace->layer, begins.value_or(Length{}), vehicle_,
                 height_rule());
  }
  return route;
}

// An answer that came too late for its instant, or for a flight that slows down already, is none.
void AgentNode::receive_grant(const FlightGrant& grant, Instant now) {
  if (!slot_.accept(grant, settings_.boot) || !slot_.is_clear()) return;
  const bool is_in_motion = slot_.claim().departure == Departure::in_motion;
  if (!is_in_motion) {
    if (now <= slot_.departs()) return;
    lead_ = std::min(2 * lead_, longest_lead);
    return slot_.drop();
  }
  const Way* way = next_way();
  const Pace& pace = aircraft_.pilot().pace();
  const double braked_m = pace.along_m() + pace.braking_m() + pace.speed_mps() * control_period_s;
  const bool is_on_time = is_airborne() && way != nullptr && braked_m < way->begins_m;
  slot_.drop();
  if (!is_on_time) return;
  ++ways_given_;
  relicense();
}

// At the beginning of a control period.
void AgentNode::mind_traffic(Instant begins) {
  if (awaits_way()) return wait_for_way(begins);
  const Way* given = way_given();
  const bool is_ahead = given != nullptr && route_piece_ < given->to_piece;
  if (is_ahead && stop_m_ < given->ends_m) --ways_given_;  // it will be late
  if (is_way_due() && aircraft_.pilot().pace().along_m() >= claim_from_m()) claim_way(begins);
}

// Hovers where a way begins that is not its own yet; as long as its pack lasts.
void AgentNode::wait_for_way(Instant begins) {
  if (!aircraft_.pilot().pace().is_at_rest()) return;
  const Way& way = *next_way();
  if (!may_fly(way)) return slot_.drop();
  if (slot_.is_refused() || (slot_.is_asked() && slot_.claim().departure == Departure::in_motion)) {
    slot_.drop();
  }
  constexpr double bends_s = 3.0;  // the time home is reckoned without
  if (phase_ == Phase::fly_back && !reaches_home(way_home_slack_s + bends_s)) {
    note("flies_unasked", "has no pack left to wait for the way home to be clear");
    ask_for_way(way, Departure::begun, begins);
    return open_way();
  }
  if (!slot_.is_asked()) return ask_for_way(way, Departure::from_hover, begins + lead_);
  if (slot_.is_clear() && begins >= slot_.departs()) open_way();
}

void AgentNode::open_way() {
  slot_.drop();
  ++ways_given_;
  if (phase_ != Phase::fly_back) return relicense();
  stop_m_ = before_blockage_m(no_stop);
}

// While it still works, so that it need not stop where the way is clear.
void AgentNode::claim_way(Instant begins) {
  const Way& way = *next_way();
  if (is_astray_ || !may_fly(way) || licensed_stop_m() < way.begins_m) return;
  ask_for_way(way, Departure::in_motion, begins);
}

void AgentNode::ask_for_way(const Way& way, Departure departure, Instant at) {
  const Pilot& pilot = aircraft_.pilot();
  auto track = coming_track({pilot.pace(), aircraft_.altitude_m(), on_grid(at, control_period)},
                            pilot.path(), route_->heights, height_rule(), way.ends_m);
  send(slot_.ask({.agent = vehicle_.id,
                  .boot = settings_.boot,
                  .claim = {},
                  .departure = departure,
                  .leads_to = cells_at_end(way, *route_),
                  .track = std::move(track)}));
}

// Where an obstacle has changed the way that it is on.
void AgentNode::announce_way() {
  if (awaits_way()) return slot_.drop();
  const Way* given = way_given();
  if (given == nullptr) return;
  if (aircraft_.pilot().pace().along_m() >= given->ends_m) return;
  ask_for_way(*given, Departure::begun, last_tick_);
  if (given->to_piece < route_->pieces.size()) slot_.drop();
}

// Hovers without a way until it is given work.
void AgentNode::forget_way() {
  route_->pieces.clear();
  route_->ways.clear();
  ways_given_ = 0;
}

// On the ground: whether its instant has come, which it is ready for then. One that it was kept
// from is given up.
bool AgentNode::may_take_off(Instant now) {
  if (slot_.is_clear() && now > slot_.departs() + control_period) slot_.drop();
  if (!slot_.is_clear() || now < slot_.departs()) return false;
  ready_ = std::max(ready_, slot_.departs());
  return true;
}

void AgentNode::ask_to_take_off(const SortieRoute& route, Instant now) {
  const Instant at = on_grid(std::max(ready_, now + lead_), control_period);
  const Pace pace{planned_acceleration_mps2(vehicle_)};
  const Way& way = route.ways.front();
  send(slot_.ask({.agent = vehicle_.id,
                  .boot = settings_.boot,
                  .claim = {},
                  .departure = Departure::from_ground,
                  .leads_to = cells_at_end(way, route),
                  .track = coming_track({pace, route.heights.altitude_m(0.0), at}, route.path,
                                        route.heights, height_rule(), way.ends_m)}));
}

CellRange AgentNode::cells_at_end(const Way& way, const SortieRoute& route) const {
  return way.to_piece < route.pieces.size() ? route.pieces[way.to_piece].piece.cells : CellRange{};
}

// The first that is not its own yet; none where nobody shares the air.
const Way* AgentNode::next_way() const {
  const bool is_left = settings_.airspace && ways_given_ < route_->ways.size();
  return is_left ? &route_->ways[ways_given_] : nullptr;
}

// The last that is its own.
const Way* AgentNode::way_given() const {
  return settings_.airspace && ways_given_ > 0 ? &route_->ways[ways_given_ - 1] : nullptr;
}

// That it is on or cannot stop before.
const Way* AgentNode::way_bound_to() const {
  const Way* way = way_given();
  const Pace& pace = aircraft_.pilot().pace();
  const bool is_on_it = way != nullptr && pace.along_m() + pace.braking_m() >= way->begins_m &&
                        progress_m_ < way->ends_m;
  return is_on_it ? way : nullptr;
}

// Whether all work before a way that is not its own is done.
bool AgentNode::awaits_way() const {
  const Way* way = is_airborne() && route_ ? next_way() : nullptr;
  return way != nullptr && route_piece_ >= way->to_piece;
}

// Whether it would go on at the end of a way, were it its own.
bool AgentNode::may_fly(const Way& way) const {
  if (phase_ == Phase::fly_back) return true;
  if (!may_work() || leaving_) return false;
  if (way.to_piece == route_->pieces.size()) return true;
  const std::uint32_t first = route_->pieces[way.to_piece].piece.cells.first;
  return ledger_.licensed_to(first) > first;
}

// Whether it comes to a way that it has not asked for.
bool AgentNode::is_way_due() const {
  const Way* way = next_way();
  return way != nullptr && route_piece_ < way->to_piece && !slot_.is_asked();
}

double AgentNode::claim_from_m() const {
  const double speed = vehicle_.spray_speed.base();
  const double brakes_m = speed * (0.5 * speed / planned_acceleration_mps2(vehicle_) + answer_s);
  return next_way()->begins_m - brakes_m;
}

}  // namespace furrow::agents
