#include "agents/agent_node.hpp"

#include "agents/control_clock.hpp"

#include <algorithm>
#include <utility>

namespace furrow::agents {

AgentNode::AgentNode(AgentSettings settings)
    : settings_{std::move(settings)},
      vehicle_{settings_.vehicle},
      aircraft_{settings_},
      log_{vehicle_.id},
      around_{settings_.avoidance},
      lookout_{settings_.surprises} {}

Outbox AgentNode::step(const Inbox& inbox, Instant now) {
  if (!is_known_) {
    is_known_ = true;
    scheduler_heard_ = next_state_ = now;
    send_info(now);
  }
  live_until(now);
  for (const Envelope& envelope : inbox) receive(envelope.body, now);
  live_until(now);
  heartbeat(now);
  return {.messages = std::exchange(out_, {}), .wake = wake_after(now)};
}

void AgentNode::receive(const Body& body, Instant now) {
  if (const auto* command = std::get_if<Command>(&body)) adopt(*command, now);
  if (const auto* state = std::get_if<SchedulerState>(&body)) receive_scheduler(*state, now);
  if (const auto* state = std::get_if<OperatorState>(&body)) obey(*state, now);
  if (const auto* grant = std::get_if<WorkGrant>(&body)) {
    const bool is_mine = grant->agent == vehicle_.id && grant->target_boot == settings_.boot;
    if (is_mine && order_ && ledger_.accept(*grant, *order_)) {
      ready_ = std::max(ready_, now);
      relicense();
    }
  }
  if (const auto* grant = std::get_if<FlightGrant>(&body)) receive_grant(*grant, now);
  if (const auto* grant = std::get_if<ServiceGrant>(&body)) {
    if (grant->agent == vehicle_.id && visit_ && visit_->accept(*grant)) {
      if (visit_->is_refused()) return go_without(now);
      if (!visit_->is_released()) {
        phase_ = Phase::service;
        ready_ = now;
      }
      send(visit_->claim());
    }
  }
}

void AgentNode::receive_scheduler(const SchedulerState& state, Instant now) {
  if (state.epoch < scheduler_epoch_) return;  // fenced off
  if (state.epoch > scheduler_epoch_) {
    scheduler_epoch_ = state.epoch;
    is_given_up_ = false;
    send_info(now);
  }
  scheduler_heard_ = now;
  is_mission_over_ = state.phase == MissionPhase::finished;
  if (std::exchange(is_scheduler_lost_, false)) note("scheduler_heard", "is back");
  heed_loss(state, now);
}

void AgentNode::note(std::string kind, std::string detail) {
  send(Event{std::move(kind), text(node(vehicle_.id)) + " " + std::move(detail)});
}

void AgentNode::acknowledge(AckStatus status, std::string reason) {
  last_ack_ = status;
  last_ack_reason_ = reason;
  send(CommandAck{.agent = vehicle_.id,
                  .boot = settings_.boot,
                  .epoch = order_->epoch(),
                  .revision = order_->revision(),
                  .status = status,
                  .reason = std::move(reason)});
}

void AgentNode::send_info(Instant now) {
  send(AgentInfo{vehicle_.id, settings_.boot, vehicle_});
  next_info_ = now + settings_.info_period;
}

void AgentNode::send_report(Instant now) {
  send(WorkReport{vehicle_.id, settings_.boot, order_->epoch(), ledger_.closures()});
  next_report_ = now + settings_.report_period;
}

// What is due by the clock alone.
void AgentNode::heartbeat(Instant now) {
  if (!order_ && now >= next_info_ && !is_mission_over_) send_info(now);
  if (order_ && !ledger_.closures().empty() && now >= next_report_) send_report(now);
  if (now < next_state_ || is_retired_) return;

  next_state_ = next_on_grid(now, whole_second);
  send(state());
  report_obstacles();
  if (slot_.is_open()) send(slot_.claim());
  if (visit_ && (!visit_->is_released() || visit_->repeat_release())) send(visit_->claim());
  if (!is_scheduler_lost_ && order_ && !is_mission_over_ &&
      now > scheduler_heard_ + settings_.scheduler_lease) {
    is_scheduler_lost_ = true;
    note("scheduler_silent", "has not heard the scheduler within its lease");
  }
  is_retired_ = is_retired();
}

AgentState AgentNode::state() const {
  const Xy ahead = aircraft_.pilot().ahead();
  return {.agent = vehicle_.id,
          .boot = settings_.boot,
          .epoch = order_ ? order_->epoch() : Epoch{},
          .revision = order_ ? order_->revision() : 0,
          .phase = phase_,
          .position = field_point(aircraft_.fix_m()),
          .heading_rad = std::atan2(ahead.x, ahead.y),
          .ground_speed = metres_per_second(norm(aircraft_.velocity_mps())),
          .tank = aircraft_.stores.tank_share,
          .battery = aircraft_.stores.pack_share,
          .sortie = order_ ? order_->sortie() : 0,
          .last_grant = ledger_.last_accepted(),
          .last_closed = ledger_.last_closed()};
}

// Nothing will ever be wanted of it again.
bool AgentNode::is_retired() const {
  const bool is_idle = phase_ == Phase::done || phase_ == Phase::idle || phase_ == Phase::offline;
  return is_mission_over_ && is_idle && ledger_.closures().empty();
}

Instant AgentNode::wake_after(Instant now) const {
  if (is_retired_) return never;
  Instant wake = next_on_grid(now, whole_second);
  if (is_airborne()) wake = std::min(wake, next_flight_event(now));
  if (visit_ && !visit_->is_waiting() && !visit_->is_released() && visit_->grant().ready > now) {
    wake = std::min(wake, visit_->grant().ready);
  }
  if (slot_.is_clear() && slot_.departs() > now) wake = std::min(wake, slot_.departs());
  return wake;
}

// No later than the tick at which the aircraft gets, at full speed, to where something changes.
Instant AgentNode::next_flight_event(Instant now) const {
  double target_m = std::min(stop_m_, route_->path.length_m());
  if (route_piece_ < route_->pieces.size()) {
    const PieceOnPath& piece = route_->pieces[route_piece_];
    target_m = std::min(target_m, progress_m_ < piece.open_m ? piece.open_m : piece.close_m);
  }
  if (is_way_due()) target_m = std::min(target_m, claim_from_m());
  const double rest_m = target_m - aircraft_.along_m();
  if (phase_ == Phase::hold && !leaving_ && !is_astray_) return never;
  const double speed_mps = std::max(vehicle_.ferry_speed, vehicle_.spray_speed).base();
  const double periods = std::max(1.0, std::floor(rest_m / speed_mps / control_period_s));
  return std::max(last_tick_ + static_cast<int>(periods) * control_period,
                  next_on_grid(now, control_period));
}

}  // namespace furrow::agents
