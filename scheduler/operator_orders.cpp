// How the scheduler obeys its operator.

#include "scheduler/events.hpp"
#include "scheduler/scheduler_node.hpp"

#include <algorithm>

namespace furrow::scheduler {

void SchedulerNode::take_orders(Instant now, Outbox& out) {
  const std::vector<TimedOrder>& orders = settings_.orders;
  for (; orders_taken_ < orders.size() && orders[orders_taken_].at <= now; ++orders_taken_) {
    take(orders[orders_taken_].order, out);
  }
}

/// A repeated order is answered already, by a level that is repeated too.
void SchedulerNode::hear(const OperatorOrder& order, Outbox& out) {
  if (order.number <= answered_order_) return;
  answered_order_ = order.number;
  refusal_ = take(order, out);
}

/// @return  Why it is not obeyed; empty when it is.
std::string SchedulerNode::take(const OperatorOrder& order, Outbox& out) {
  std::string why = refusal(order);
  if (!why.empty()) {
    out.messages.push_back(event("order_refused", why));
    return why;
  }
  switch (order.ask) {
    case OperatorAsk::pause:
      set_level(FleetLevel::hold, "fleet_paused", "holds the fleet where it is", out);
      break;
    case OperatorAsk::resume:
      set_level(FleetLevel::fly, "fleet_resumed", "lets the fleet go on", out);
      break;
    case OperatorAsk::return_all:
      set_level(FleetLevel::land, "fleet_recalled", "calls the fleet to the stations", out);
      break;
    case OperatorAsk::stop:
      set_level(FleetLevel::end, "mission_stopped", "ends the mission", out);
      break;
    case OperatorAsk::take_out: take_out(order.agent, "as the operator orders", out); break;
  }
  return why;
}

/// Why an order is not obeyed; empty when it is.
std::string SchedulerNode::refusal(const OperatorOrder& order) const {
  if (level_ == FleetLevel::end && order.ask != OperatorAsk::stop) {
    return "the mission is stopped, which is final";
  }
  if (order.ask != OperatorAsk::take_out) return {};
  const auto m = std::find_if(members_.begin(), members_.end(),
                              [&](const Member& other) { return other.agent == order.agent; });
  if (m == members_.end()) return text(order.agent) + " is not of this mission";
  return m->lost ? text(order.agent) + " is lost" : "";
}

void SchedulerNode::set_level(FleetLevel level, std::string_view kind, std::string_view what,
                              Outbox& out) {
  if (level == level_) return;
  level_ = level;
  ++level_revision_;
  out.messages.push_back(
      event(kind, text(scheduler_node()) + " " + std::string{what} + ", as the operator orders"));
}

/// While the fleet is held all forecasts move with the clock.
void SchedulerNode::keep_time(Instant now) {
  if (held_since_) {
    const double held_s = seconds(now - *held_since_).base();
    for (Member& m : members_) {
      if (!m.pieces.empty()) m.lands_s += held_s;
    }
  }
  const bool is_held = level_ == FleetLevel::hold || level_ == FleetLevel::land;
  held_since_ = is_held && phase_ == MissionPhase::flying ? std::optional{now} : std::nullopt;
}

void SchedulerNode::take_out(AgentId agent, std::string_view why, Outbox& out) {
  for (Member& m : members_) {
    if (m.agent != agent || m.is_out) continue;
    m.is_out = true;
    ++level_revision_;
    out.messages.push_back(
        event("agent_taken_out", text(agent) + " goes home for good, " + std::string{why}));
  }
}

/// When it has to turn for home to be down at the end of its window.
Instant SchedulerNode::called_home(const Member& m) const {
  constexpr double detours = 1.3;
  constexpr Seconds kept = seconds(30.0);
  if (!m.vehicle.available_until) return never;
  const Length away = distance(m.place.position, haven(m.station, 0.0).position);
  const Seconds home = detours * away / m.vehicle.ferry_speed + kept;
  return instant(std::max(*m.vehicle.available_until - home, Seconds{}));
}

/// Takes out whoever has to go home.
void SchedulerNode::close_windows(Instant now, Outbox& out) {
  for (const Member& m : members_) {
    if (m.lost || m.is_out || now < called_home(m)) continue;
    if (has_work_left(m)) take_out(m.agent, "as its window ends", out);
  }
}

/// Leaves the rest of the lists of those taken out to the others, once all their windows are
/// closed.
void SchedulerNode::hand_over() {
  for (Member& m : members_) {
    if (!m.is_out || m.lost || m.pieces.empty() || !ledger_.windows(m.agent).empty()) continue;
    const std::vector<CellRange> open = open_cells(m);
    orphans_.insert(orphans_.end(), open.begin(), open.end());
    m.sorties.clear();
    m.pieces.clear();
  }
}

/// Gives up what nobody holds once the mission is stopped.
void SchedulerNode::wind_up(Outbox& out) {
  if (level_ != FleetLevel::end) return;
  orphans_.clear();
  const auto cells = static_cast<std::uint32_t>(settings_.plan.route.centers.size());
  abandon({0, cells}, "the operator stopped the mission", out);
}

void SchedulerNode::report_orders(Outbox& out) {
  reported_revision_ = level_revision_;
  reported_order_ = answered_order_;
  if (level_revision_ == 0 && answered_order_ == 0) return;
  OperatorState state{.epoch = settings_.epoch,
                      .revision = level_revision_,
                      .level = level_,
                      .taken_out = {},
                      .answered = answered_order_,
                      .refusal = refusal_};
  for (const Member& m : members_) {
    if (m.is_out) state.taken_out.push_back(m.agent);
  }
  out.messages.push_back(std::move(state));
}

}  // namespace furrow::scheduler
