#include "agents/agent_node.hpp"
#include "agents/control_clock.hpp"
#include "agents/guidance/coming_track.hpp"

#include <algorithm>
#include <utility>

namespace furrow::agents {
namespace {

constexpr double answer_s = 3.0;  // in which the way home is answered before it must brake
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
  const Pace& pace = aircraft_.pilot().pace();
  const double braked_m = pace.braking_m() + pace.speed_mps() * control_period_s;
  const bool is_on_time = is_airborne() && pace.along_m() + braked_m < work_end_m();
  if (!is_on_time) return slot_.drop();
  is_way_home_clear_ = true;
  relicense();
}

// At the beginning of a control period.
void AgentNode::mind_traffic(Instant begins) {
  if (awaits_way()) return wait_for_way(begins);
  const bool stops_first = phase_ != Phase::fly_back && stop_m_ < no_stop;
  if (stops_first && std::exchange(is_way_home_clear_, false)) slot_.drop();  // it will be late
  if (is_way_home_due() && aircraft_.pilot().pace().along_m() >= claim_from_m()) {
    claim_way_home(begins);
  }
}

// Hovers where a way begins that is not its own yet; as long as its pack lasts.
void AgentNode::wait_for_way(Instant begins) {
  if (!aircraft_.pilot().pace().is_at_rest()) return;
  if (slot_.is_refused() || (slot_.is_asked() && slot_.claim().departure == Departure::in_motion)) {
    slot_.drop();
  }
  if (!reaches_home(way_home_slack_s)) {
    note("flies_unasked", "has no pack left to wait for the way home to be clear");
    ask_for_way(Departure::begun, begins);
    return open_way();
  }
  if (!slot_.is_asked()) return ask_for_way(Departure::from_hover, begins + lead_);
  if (slot_.is_clear() && begins >= slot_.departs()) open_way();
}

void AgentNode::open_way() {
  slot_.drop();
  const bool is_home = phase_ == Phase::fly_back;
  if (is_way_out_clear_ || is_home) is_way_home_clear_ = true;
  is_way_out_clear_ = true;
  stop_m_ = before_blockage_m(is_home ? no_stop : licensed_stop_m());
}

// While it still works, so that it need not stop where the way is clear.
void AgentNode::claim_way_home(Instant begins) {
  if (leaving_ || is_astray_ || !may_work() || licensed_stop_m() < work_end_m()) return;
  ask_for_way(Departure::in_motion, begins);
}

void AgentNode::ask_for_way(Departure departure, Instant at) {
  const double to_m = is_way_out_clear_ ? route_->path.length_m() : first_way_m(*route_);
  const Pilot& pilot = aircraft_.pilot();
  auto track = coming_track({pilot.pace(), aircraft_.altitude_m(), on_grid(at, control_period)},
                            pilot.path(), route_->heights, height_rule(), to_m);
  send(slot_.ask(vehicle_.id, settings_.boot, departure, std::move(track)));
}

// Where an obstacle has changed the way that it is on.
void AgentNode::announce_way() {
  if (!settings_.airspace || awaits_way()) return;
  const bool is_on_way = phase_ == Phase::fly_out || phase_ == Phase::fly_back;
  if (is_on_way || is_way_home_clear_) ask_for_way(Departure::begun, last_tick_);
  if (phase_ == Phase::fly_out) slot_.drop();
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
  const Pace pace{route.path, planned_acceleration_mps2(vehicle_)};
  send(slot_.ask(vehicle_.id, settings_.boot, Departure::from_ground,
                 coming_track({pace, route.heights.altitude_m(0.0), at}, route.path, route.heights,
                              height_rule(), first_way_m(route))));
}

bool AgentNode::awaits_way() const {
  if (!settings_.airspace || !is_airborne() || !route_) return false;
  return !is_way_out_clear_ ||
         (phase_ == Phase::fly_back && !route_->pieces.empty() && !is_way_home_clear_);
}

// Whether it comes to the way home and has not asked for it.
bool AgentNode::is_way_home_due() const {
  return settings_.airspace && !is_way_home_clear_ && is_way_out_clear_ && !slot_.is_asked() &&
         !route_->pieces.empty() && phase_ != Phase::fly_back;
}

double AgentNode::work_end_m() const {
  const PieceOnPath& last = route_->pieces.back();
  const std::size_t i = route_->pieces.size() - 1;
  return last.has_tail() ? last.close_m : route_->cell_m(i, last.piece.cells.count - 1);
}

double AgentNode::claim_from_m() const {
  const double speed = vehicle_.spray_speed.base();
  const double brakes_m = speed * (0.5 * speed / planned_acceleration_mps2(vehicle_) + answer_s);
  return work_end_m() - brakes_m;
}

}  // namespace furrow::agents
