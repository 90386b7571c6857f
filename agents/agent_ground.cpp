#include "agents/agent_node.hpp"
#include "agents/control_clock.hpp"
#include "agents/text.hpp"
#include "core/require.hpp"

#include <algorithm>
#include <utility>

namespace furrow::agents {
namespace {

constexpr double nothing_to_fill = 1e-9;

// What a tank that cannot be filled must still hold for one more sortie.
constexpr double least_tank = 0.05, least_cells = 4.0;
constexpr double hair_m = 1e-3;

}  // namespace

void AgentNode::adopt(const Command& command, Instant now) {
  if (command.agent != vehicle_.id || command.target_boot != settings_.boot) return;
  if (order_ && order_->is_same_as(command)) {  // sent again, so the answer was lost
    return acknowledge(last_ack_, last_ack_reason_);
  }
  if (command.epoch < scheduler_epoch_ || (order_ && !order_->is_older_than(command))) return;
  scheduler_epoch_ = command.epoch;

  const double wind_mps = (settings_.wind.mean + 2.0 * settings_.wind.gust).base();
  auto fault = fault_in(command, settings_.stations,
                        is_revision(command) ? ledger_.sprayed_cells() : std::set<std::uint32_t>{});
  if (!fault && wind_mps > workable_wind_mps(vehicle_)) {
    fault = "gusts of " + fixed(wind_mps, 1) + " m/s leave no headway, " +
            fixed(workable_wind_mps(vehicle_), 1) + " m/s is the most";
  }
  if (!fault) fault = unholdable(vehicle_);
  if (!fault) return replace_order(command, now);
  send(CommandAck{.agent = vehicle_.id,
                  .boot = settings_.boot,
                  .epoch = command.epoch,
                  .revision = command.revision,
                  .status = AckStatus::rejected,
                  .reason = *fault});
}

bool AgentNode::is_revision(const Command& command) const {
  return order_ && order_->epoch() == command.epoch;
}

void AgentNode::replace_order(const Command& command, Instant now) {
  const bool revises = is_revision(command);
  Order next = revises ? Order{command, ledger_.sprayed_cells()} : Order{command};
  const bool goes_on = revises && keeps_course(next);
  if (order_ && !goes_on) {
    ledger_.close_all(CloseReason::superseded, now);
    if (!ledger_.closures().empty()) send_report(now);
    if (!revises) ledger_.restart();
  }
  order_ = std::move(next);
  if (!is_airborne() && !diverts_) slot_.drop();
  bool is_news = false;
  for (const SeenObstacle& o : order_->obstacles()) is_news |= around_.learn(o);
  is_running_ = is_running_ && goes_on;
  acknowledge(AckStatus::received);
  acknowledge(AckStatus::accepted);
  if (is_running_) acknowledge(AckStatus::running);

  const bool stands = phase_ == Phase::idle || phase_ == Phase::wait;
  if (is_airborne() && phase_ != Phase::fly_back) {
    if (!goes_on && !leaving_) {
      leave(CloseReason::superseded, now);
    } else if (is_news) {
      reroute(now);
    }
  } else if (is_airborne()) {
    if (is_news) reroute(now);
  } else if (stands && order_->is_finished() && (!visit_ || visit_->is_released())) {
    finish(now);
  } else if (phase_ == Phase::done && !order_->is_finished()) {
    phase_ = Phase::wait;
    prepare(now);
    has_unreported_sortie_ = sorties_flown_ > 0 && !is_prepared_;  // of its service, later
  }
}

// Whether a revision leaves its windows and the rest of the sortie in the air as they are.
bool AgentNode::keeps_course(const Order& next) const {
  if (!ledger_.fits(next)) return false;
  if (!is_airborne() || phase_ == Phase::fly_back) return true;
  const std::size_t pieces = route_->pieces.size();
  if (route_piece_ >= pieces) return false;  // hovers without a way
  if (route_piece_ + 1 == pieces && is_on_tail()) return true;
  return !order_->is_finished() && !next.is_finished() && order_->goes_on_as(next);
}

// Everything that happens up to `now` without a message, in order of time.
void AgentNode::live_until(Instant now) {
  for (;;) {
    while (is_airborne() && last_tick_ + control_period <= now) {
      fly_one_period(last_tick_ + control_period);
    }
    if (is_airborne() || phase_ == Phase::offline) return;
    if (visit_ && visit_->is_served(now)) {
      leave_bay();
    } else if (diverts_ && may_work()) {
      try_divert(now);
      if (!is_airborne()) return;
    } else if (is_prepared_ && is_licensed() && may_work()) {
      try_take_off(now);
      if (!is_airborne()) return;
    } else {
      return;
    }
  }
}

// On the ground at a station: asks for what the next sortie needs, if anything.
void AgentNode::prepare(Instant t) {
  ready_ = std::max(ready_, t);
  const Demand wanted = demand();
  is_prepared_ = !wanted.swap && wanted.fill <= nothing_to_fill;
  if (is_prepared_) return report_sortie();
  if (closed_.contains(home_.id) && go_elsewhere(t)) return;
  visit_.emplace(vehicle_.id, settings_.boot, home_.id, ++claims_, t, wanted.swap, wanted.fill);
  send(visit_->claim());
}

AgentNode::Demand AgentNode::demand() const {
  const auto rest = order_->rest_of_sortie();
  const Xy next_home = xy_m(haven().position);
  const auto route =
      sortie_route(aircraft_.estimate_m(), rest, next_home, vehicle_, settings_.ferries, around_);

  const double tank = aircraft_.stores.tank_share;
  const double share = std::min(1.0, route.spray_m / tank_range(vehicle_).base());
  double time_s = wanted_pack_s(route.path.duration_s());
  if (const planner::Relief* relief = settings_.ferries.relief()) {
    time_s += relief->rule().climb_energy_s_per_m * route.heights.climb_m();
  }
  // A tank that was emptied to the last drop may be below zero by rounding.
  const double fill = std::clamp(share - tank, 0.0, 1.0);
  return {.swap = aircraft_.stores.pack_share < 1.0 &&
                  aircraft_.stores.flight_left_s(vehicle_) < time_s,
          .fill = fill > nothing_to_fill ? fill : 0.0};
}

void AgentNode::leave_bay() {
  ready_ = std::max(ready_, visit_->grant().ready);
  const ServiceClaim& claim = visit_->claim();
  const Station& at = station(claim.station);
  const bool swaps = visit_->swaps();
  const double fills = visit_->fills();
  if (swaps) {
    aircraft_.stores.pack_share = 1.0;
    ++pack_;
  }
  aircraft_.stores.tank_share = std::min(1.0, aircraft_.stores.tank_share + fills);
  sortie_.serviced = true;
  sortie_.station = claim.station;
  sortie_.bay = visit_->grant().bay;
  sortie_.swapped = swaps;
  sortie_.filled = fills;
  sortie_.wait = seconds(visit_->grant().starts - claim.first_claimed);
  sortie_.swap_time = swaps ? at.battery_swap : Seconds{};
  sortie_.fill_time = fill_time(at, fills);
  note_lack(swaps, fills);
  visit_->release();
  send(visit_->claim());
  report_sortie();
  is_prepared_ = true;
  phase_ = Phase::wait;
  if (order_->is_finished()) return finish(ready_);
  if (is_dismissed()) dismiss(ready_);
}

// The station cannot help it: it goes to another, or flies with what it has, as far as that goes.
void AgentNode::go_without(Instant t) {
  ready_ = std::max(ready_, t);
  note_lack(false, 0.0);
  closed_.insert(home_.id);
  visit_->release();
  send(visit_->claim());
  report_sortie();
  is_prepared_ = true;
  if (order_->is_finished()) return finish(ready_);
  go_elsewhere(ready_);
}

// Flies to the nearest station that has not refused it. @return Whether there is one within reach.
bool AgentNode::go_elsewhere(Instant t) {
  if (!may_work()) return false;
  const FieldPoint here = field_point(aircraft_.estimate_m());
  const Station* other = nearest_open(here);
  if (other == nullptr) return false;
  const double there_s =
      straight_way_s(ferry_pack_m(here, other->position, vehicle_, settings_.ferries), vehicle_);
  if (wanted_pack_s(there_s) > aircraft_.stores.flight_left_s(vehicle_)) return false;
  report_sortie();
  home_ = *other;
  note("goes_elsewhere", "goes to station " + std::to_string(number(other->id)));
  diverts_ = true;
  slot_.drop();
  try_divert(t);
  return true;
}

void AgentNode::try_divert(Instant now) {
  const bool may_go = !settings_.airspace || may_take_off(now);
  if (!may_go && slot_.is_asked()) return;
  SortieRoute route = lay(aircraft_.estimate_m(), {});
  if (!may_go) return ask_to_take_off(route, now);
  diverts_ = false;
  take_off(std::move(route), ready_);
}

const Station* AgentNode::nearest_open(FieldPoint from) const {
  const Station* nearest = nullptr;
  for (const Station& s : settings_.stations) {
    if (closed_.contains(s.id)) continue;
    const bool is_nearer =
        nearest == nullptr || distance(from, s.position) < distance(from, nearest->position);
    if (is_nearer) nearest = &s;
  }
  return nearest;
}

// Where the sortie ends: where the order says, or at the nearest station that has not refused it,
// or where it is.
const Station& AgentNode::haven() const {
  const Station& ordered = station(order_->station());
  if (!closed_.contains(ordered.id)) return ordered;
  const Station* open = nearest_open(ordered.position);
  return open == nullptr ? home_ : *open;
}

// Keeps in words what it was given less of than it claimed.
void AgentNode::note_lack(bool swap, double fill) {
  const ServiceClaim& claim = visit_->claim();
  const bool lacks_pack = claim.swap && !swap, lacks_mix = fill < claim.fill;
  lack_.clear();
  if (!lacks_pack && !lacks_mix) return;
  const char* what = !lacks_mix ? "charged pack" : lacks_pack ? "mix and charged pack" : "mix";
  const bool closes = station(claim.station).available_until && lacks_mix && fill <= 0.0;
  lack_ = "station " + std::to_string(number(claim.station)) +
          (closes ? " serves it no more" : std::string{" has no "} + what + " for it");
  note("not_served", "finds that " + lack_);
}

bool AgentNode::is_licensed() const {
  if (!order_ || order_->is_finished()) return false;
  return ledger_.licensed_to(order_->next_cell()) > order_->next_cell();
}

void AgentNode::try_take_off(Instant now) {
  const bool may_go = !settings_.airspace || may_take_off(now);
  if (!may_go && slot_.is_asked()) return;
  const Instant t = ready_;
  const auto rest = order_->rest_of_sortie();
  home_ = haven();
  const FieldPoint here = field_point(aircraft_.estimate_m()), entry = rest.front().entry;
  const double there_and_back_s =
      straight_way_s(ferry_pack_m(here, entry, vehicle_, settings_.ferries), vehicle_) +
      straight_way_s(ferry_pack_m(entry, home_.position, vehicle_, settings_.ferries), vehicle_);
  if (wanted_pack_s(there_and_back_s) > aircraft_.stores.flight_left_s(vehicle_)) {
    const std::string cell = "cell " + std::to_string(order_->next_cell());
    return give_up(CloseReason::battery_low,
                   lack_.empty() ? cell + " is out of reach of one pack" : lack_, t);
  }
  SortieRoute route = lay(aircraft_.estimate_m(), rest);
  if (lacks_mix(route)) return give_up(CloseReason::tank_low, lack_, t);
  if (!may_go) return ask_to_take_off(route, now);
  take_off(std::move(route), t);
}

// Whether the station left it with so little that a sortie is not worth its flight.
bool AgentNode::lacks_mix(const SortieRoute& route) const {
  if (lack_.empty()) return false;
  const double least_m =
      least_tank * tank_range(vehicle_).base() + least_cells * route.pieces.front().spacing_m;
  return aircraft_.stores.spray_left_m(vehicle_) < std::min(least_m, route.spray_m) - hair_m;
}

// On the ground: its work is for others.
void AgentNode::give_up(CloseReason reason, std::string why, Instant t) {
  ledger_.close_all(reason, t);
  send_report(t);
  phase_ = Phase::offline;
  acknowledge(AckStatus::failed, std::move(why));
}

void AgentNode::take_off(SortieRoute route, Instant t) {
  last_tick_ = on_grid(t, control_period);
  sortie_ = {};
  sortie_.agent = vehicle_.id;
  sortie_.sortie = sorties_flown_++;
  const bool works = !route.pieces.empty();  // else it only changes its station
  sortie_.resumed_at =
      works ? route.pieces.front().piece.entry : field_point(aircraft_.estimate_m());
  sortie_.returned_at = sortie_.resumed_at;
  sortie_.pack = pack_;
  sortie_.began = sortie_.spray_ended = last_tick_;
  has_unreported_sortie_ = true;

  flown_m_ = climb_s_ = 0.0;
  route_.reset();
  aircraft_.take_off();
  aircraft_.start_at(route.heights.altitude_m(0.0));
  follow(std::move(route));
  ways_given_ = 1;
  phase_ = works ? Phase::fly_out : Phase::fly_back;
  if (!works) stop_m_ = before_blockage_m(no_stop);
  log_.point(last_tick_, aircraft_.truth_m(), aircraft_.altitude_m(), false);
  if (!is_running_) acknowledge(AckStatus::running);
  is_running_ = true;
  note("sortie_begun", "takes off for sortie " + std::to_string(sortie_.sortie + 1) + ", " +
                           fixed(route_->spray_m, 1) + " m to spray");
  relicense();
}

void AgentNode::land(Instant t) {
  aircraft_.land();
  slot_.drop();
  if (t != on_grid(t, whole_second))
    log_.point(t, aircraft_.truth_m(), aircraft_.altitude_m(), false);
  flush_flight_log();
  sortie_.landed = t;
  sortie_.flight = seconds(t - sortie_.began);
  sortie_.battery_used = (sortie_.flight + seconds(climb_s_)) / vehicle_.flight_endurance;
  sortie_.ferried = metres(flown_m_ + aircraft_.pilot().pace().along_m()) - sortie_.sprayed;
  if (order_->is_finished()) return finish(t);
  if (is_unfit_) return leave_fleet(t);
  if (is_dismissed()) return dismiss(t);
  phase_ = Phase::wait;
  prepare(t);
}

void AgentNode::leave_fleet(Instant t) {
  report_sortie();
  ledger_.close_all(CloseReason::strayed, t);
  send_report(t);
  phase_ = Phase::offline;
  acknowledge(AckStatus::failed,
              "could not be held on its line at cell " + std::to_string(order_->next_cell()));
}

// The pack is empty in the air. Nothing but a broken model of energy leads here, yet nobody else
// may be made to wait for this aircraft.
void AgentNode::fall(Instant t) {
  is_valve_open_ = false;
  log_.point(t, aircraft_.truth_m(), aircraft_.altitude_m(), false);
  aircraft_.land();
  flush_flight_log();
  ledger_.close_all(CloseReason::battery_low, t);
  send_report(t);
  phase_ = Phase::offline;
  note("pack_empty", "is down where it was, its pack is empty");
  acknowledge(AckStatus::failed, "pack empty in the air");
}

void AgentNode::finish(Instant t) {
  report_sortie();
  diverts_ = false;
  slot_.drop();
  phase_ = Phase::done;
  is_prepared_ = true;
  note("order_done", "has done its order at " + fixed(seconds(t).base(), 1) + " s");
  acknowledge(AckStatus::done);
}

void AgentNode::report_sortie() {
  if (!has_unreported_sortie_) return;
  has_unreported_sortie_ = false;
  send(sortie_);
}

const Station& AgentNode::station(StationId id) const {
  const auto found = std::find_if(settings_.stations.begin(), settings_.stations.end(),
                                  [&](const Station& s) { return s.id == id; });
  require(found != settings_.stations.end(), "an accepted order names known stations only");
  return *found;
}

}  // namespace furrow::agents
