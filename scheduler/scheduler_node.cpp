#include "scheduler/scheduler_node.hpp"

#include "core/require.hpp"
#include "scheduler/orders.hpp"

#include <algorithm>
#include <string>

namespace furrow::scheduler {
namespace {

constexpr std::uint32_t revision = 1;  // a plan is commanded once
constexpr Duration resend_after = std::chrono::seconds{2};
constexpr Duration state_period = std::chrono::seconds{2};

Event event(std::string_view kind, std::string detail) {
  return {std::string{kind}, std::move(detail)};
}

std::string text(CellRange cells) {
  return "cells " + std::to_string(cells.first) + " to " + std::to_string(end(cells) - 1) + " (" +
         std::to_string(cells.count) + ")";
}

std::string text(AgentId agent) { return furrow::text(node(agent)); }

bool is_due(const std::optional<Instant>& last, Instant now) {
  return !last || now - *last >= resend_after;
}

std::string missed_detail(const planner::Route& route) {
  const FieldPoint first = route.missed.front();
  return std::to_string(route.missed.size()) +
         " workable cells are not sprayed: the coverage route leaves them out, the first at (" +
         std::to_string(first.x.base()) + ", " + std::to_string(first.y.base()) + ") m";
}

}  // namespace

SchedulerNode::SchedulerNode(SchedulerSettings settings)
    : settings_{std::move(settings)},
      ledger_{static_cast<std::uint32_t>(settings_.plan.route.centers.size())} {
  require(settings_.windows_ahead >= 1, "an agent has a window to work on");
  require(number(settings_.epoch) > 0, "an epoch is counted from 1");
  for (const UavPlan& uav : settings_.plan.uavs) {
    Member m{.agent = uav.vehicle.id,
             .share = uav.cells,
             .sorties = orders(settings_.plan.route, uav),
             .pieces = {}};
    m.pieces = pieces(m.sorties);
    members_.push_back(std::move(m));
  }
}

Outbox SchedulerNode::step(const Inbox& inbox, Instant now) {
  Outbox out;
  if (phase_ != MissionPhase::finished) {
    for (const Envelope& envelope : inbox) hear(envelope, now, out);
    check_leases(now, out);
    gather(now, out);
    if (phase_ == MissionPhase::flying) {
      for (Member& m : members_) direct(m, now, out);
    }
    check_limit(now, out);
    finish_if_done(out);
  }
  report_state(now, out);
  out.wake = next_wake(now);
  return out;
}

/// The member that a message is from, or none if nobody listens to that agent or incarnation.
SchedulerNode::Member* SchedulerNode::member(AgentId agent, BootId boot, Instant now) {
  const auto it = std::find_if(members_.begin(), members_.end(),
                               [agent](const Member& m) { return m.agent == agent; });
  if (it == members_.end() || it->lost) return nullptr;
  if (!it->boot) it->boot = boot;
  if (*it->boot != boot) return nullptr;
  it->last_heard = now;
  return &*it;
}

void SchedulerNode::hear(const Envelope& envelope, Instant now, Outbox& out) {
  if (const auto* info = std::get_if<AgentInfo>(&envelope.body)) hear(*info, now, out);
  if (const auto* state = std::get_if<AgentState>(&envelope.body)) hear(*state, now, out);
  if (const auto* ack = std::get_if<CommandAck>(&envelope.body)) hear(*ack, now, out);
  if (const auto* report = std::get_if<WorkReport>(&envelope.body)) hear(*report, now, out);
}

void SchedulerNode::hear(const AgentInfo& info, Instant now, Outbox&) {
  member(info.agent, info.boot, now);
}

void SchedulerNode::hear(const AgentState& state, Instant now, Outbox& out) {
  Member* m = member(state.agent, state.boot, now);
  if (m == nullptr) return;
  m->phase = state.phase;
  const bool follows = state.epoch == settings_.epoch && state.revision == revision;
  if (follows) m->accepted = true;
  if (state.phase == Phase::offline && has_work_left(*m)) {
    lose(*m, "it left the fleet", out);
    return;
  }
  const bool lacks_grant = state.last_grant < ledger_.last_granted(m->agent);
  const bool lacks_receipt = state.last_closed > ledger_.last_booked(m->agent);
  if (follows && (lacks_grant || lacks_receipt) && is_due(m->granted_at, now)) m->owes_grant = true;
}

void SchedulerNode::hear(const CommandAck& ack, Instant now, Outbox& out) {
  Member* m = member(ack.agent, ack.boot, now);
  if (m == nullptr || ack.epoch != settings_.epoch || ack.revision != revision) return;
  switch (ack.status) {
    case AckStatus::accepted:
    case AckStatus::running:
    case AckStatus::done: m->accepted = true; break;
    case AckStatus::rejected:
    case AckStatus::failed:
    case AckStatus::cancelled: lose(*m, "it does not follow its order: " + ack.reason, out); break;
    case AckStatus::received: break;
  }
}

void SchedulerNode::hear(const WorkReport& report, Instant now, Outbox& out) {
  Member* m = member(report.agent, report.boot, now);
  if (m == nullptr || report.epoch != settings_.epoch) return;
  for (const Closure& closure : report.closures) {
    switch (ledger_.book(m->agent, closure)) {
      case Booking::booked: m->owes_grant = true; break;
      case Booking::known:  // the receipt may have been lost
        if (is_due(m->granted_at, now)) m->owes_grant = true;
        break;
      case Booking::refused:
        out.messages.push_back(event(
            "closure_refused", text(m->agent) + " closed grant " + std::to_string(closure.grant) +
                                   " with " + text(closure.cells) + ", which was not granted so"));
        break;
    }
  }
}

/// Ends the gathering once every agent is heard of or lost.
void SchedulerNode::gather(Instant now, Outbox& out) {
  if (phase_ != MissionPhase::gathering) return;
  const bool is_over = now >= Instant{settings_.gather_time};
  for (Member& m : members_) {
    if (!m.boot && !m.lost && is_over) lose(m, "it was never heard of", out);
  }
  const bool is_complete = std::all_of(members_.begin(), members_.end(),
                                       [](const Member& m) { return m.boot || m.lost; });
  if (!is_complete) return;
  phase_ = MissionPhase::flying;
  if (!settings_.plan.route.missed.empty()) {
    out.messages.push_back(event("cells_missed", missed_detail(settings_.plan.route)));
  }
}

void SchedulerNode::check_leases(Instant now, Outbox& out) {
  for (Member& m : members_) {
    if (!is_leased(m) || now - m.last_heard < settings_.agent_lease) continue;
    lose(m,
         "nothing was heard of it for " + std::to_string(seconds(now - m.last_heard).base()) + " s",
         out);
  }
}

void SchedulerNode::check_limit(Instant now, Outbox& out) {
  if (now < Instant{settings_.mission_limit}) return;
  out.messages.push_back(event("mission_limit", "the mission takes longer than its limit of " +
                                                    std::to_string(seconds(now).base()) + " s"));
  for (Member& m : members_) give_up(m, "mission_limit", out);
  phase_ = MissionPhase::finished;
}

void SchedulerNode::lose(Member& m, std::string_view why, Outbox& out) {
  m.lost = true;
  out.messages.push_back(event("agent_lost", text(m.agent) + ": " + std::string{why}));
  give_up(m, "agent_lost", out);
}

/// Decides what becomes of the work of an agent that will not do it: nobody else takes it over.
void SchedulerNode::give_up(Member& m, std::string_view why, Outbox& out) {
  const std::string reason = " of " + text(m.agent) + ": " + std::string{why};
  for (const CellRange cells : ledger_.forsake(m.agent)) {
    out.messages.push_back(event("cells_uncertain", text(cells) + reason));
  }
  for (const CellRange cells : ledger_.abandon(m.share)) {
    out.messages.push_back(event("cells_abandoned", text(cells) + reason));
  }
}

/// Sends the agent what it lacks.
void SchedulerNode::direct(Member& m, Instant now, Outbox& out) {
  if (m.lost) return;
  if (!m.accepted) {
    if (is_due(m.commanded_at, now)) command(m, now, out);
    return;
  }
  release(m);
  if (m.owes_grant) send_grant(m, now, out);
}

void SchedulerNode::command(Member& m, Instant now, Outbox& out) {
  out.messages.push_back(Command{.agent = m.agent,
                                 .target_boot = *m.boot,
                                 .epoch = settings_.epoch,
                                 .revision = revision,
                                 .sorties = m.sorties});
  m.commanded_at = now;
}

/// Opens windows until enough are open, lowest cells first, so the rest of one closed early comes
/// before what lies behind it.
void SchedulerNode::release(Member& m) {
  std::size_t open = ledger_.windows(m.agent).size();
  for (; open < settings_.windows_ahead; ++open) {
    const auto run = ledger_.first_open(m.share);
    if (!run) return;
    const auto after =
        std::upper_bound(m.pieces.begin(), m.pieces.end(), run->first,
                         [](std::uint32_t c, const Piece& p) { return c < p.cells.first; });
    const std::uint32_t stop = std::min(end(*run), end(std::prev(after)->cells));
    ledger_.grant(m.agent, {run->first, stop - run->first});
    m.owes_grant = true;
  }
}

void SchedulerNode::send_grant(Member& m, Instant now, Outbox& out) {
  out.messages.push_back(WorkGrant{.agent = m.agent,
                                   .target_boot = *m.boot,
                                   .epoch = settings_.epoch,
                                   .revision = revision,
                                   .closed_through = ledger_.closed_through(m.agent),
                                   .windows = ledger_.windows(m.agent)});
  m.granted_at = now;
  m.owes_grant = false;
}

bool SchedulerNode::has_work_left(const Member& m) const {
  return ledger_.first_open(m.share) || !ledger_.windows(m.agent).empty();
}

/// Whether an agent is on the ground for good.
bool SchedulerNode::is_down(const Member& m) const {
  const bool has_left = m.phase == Phase::done || m.phase == Phase::offline;
  return m.lost || has_left || (m.share.count == 0 && m.phase == Phase::idle);
}

/// Whether an agent's silence means something: once it is down it may be switched off.
bool SchedulerNode::is_leased(const Member& m) const { return m.boot && !is_down(m); }

void SchedulerNode::finish_if_done(Outbox& out) {
  if (phase_ != MissionPhase::flying) return;
  const CellCounts& cells = ledger_.counts();
  const bool all_down =
      std::all_of(members_.begin(), members_.end(), [this](const Member& m) { return is_down(m); });
  if (cells.open + cells.granted > 0 || !all_down) return;
  phase_ = MissionPhase::finished;
  out.messages.push_back(
      event("mission_finished", std::to_string(cells.sprayed) + " cells sprayed, " +
                                    std::to_string(cells.abandoned) + " abandoned, " +
                                    std::to_string(cells.uncertain) + " uncertain"));
}

SchedulerState SchedulerNode::state() const {
  const CellCounts& cells = ledger_.counts();
  SchedulerState state{.epoch = settings_.epoch,
                       .phase = phase_,
                       .completed = false,
                       .sprayed_cells = cells.sprayed,
                       .open_cells = cells.open + cells.granted,
                       .abandoned_cells = cells.abandoned + cells.uncertain,
                       .lost = {}};
  state.completed = phase_ == MissionPhase::finished && state.abandoned_cells == 0;
  for (const Member& m : members_) {
    if (m.lost) state.lost.push_back(m.agent);
  }
  return state;
}

void SchedulerNode::report_state(Instant now, Outbox& out) {
  if (now < state_due_ && reported_phase_ == phase_) return;
  if (phase_ == MissionPhase::finished && farewells_-- <= 0) return;
  out.messages.push_back(state());
  reported_phase_ = phase_;
  state_due_ = Instant{(now.time_since_epoch() / state_period + 1) * state_period};
}

Instant SchedulerNode::next_wake(Instant now) const {
  if (phase_ == MissionPhase::finished) return farewells_ > 0 ? state_due_ : never;
  Instant next = std::min(state_due_, Instant{settings_.mission_limit});
  if (phase_ == MissionPhase::gathering) next = std::min(next, Instant{settings_.gather_time});
  for (const Member& m : members_) {
    if (is_leased(m)) next = std::min(next, m.last_heard + settings_.agent_lease);
  }
  return std::max(next, now + Duration{1});
}

}  // namespace furrow::scheduler
