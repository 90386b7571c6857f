#include "scheduler/scheduler_node.hpp"

#include "core/require.hpp"
#include "scheduler/events.hpp"
#include "scheduler/orders.hpp"
#include "scheduler/remnant.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

namespace furrow::scheduler {
namespace {

constexpr Duration resend_after = std::chrono::seconds{2};
constexpr Duration ask_after = std::chrono::milliseconds{500};
constexpr Duration state_period = std::chrono::seconds{2};

CellRange whole(const Ledger& ledger) {
  const CellCounts& n = ledger.counts();
  return {0, n.open + n.granted + n.sprayed + n.abandoned + n.uncertain};
}

std::string text(const SeenObstacle& o) {
  return " of " + std::to_string(o.radius.base()) + " m at (" + std::to_string(o.center.x.base()) +
         ", " + std::to_string(o.center.y.base()) + ") m";
}

std::vector<SeenObstacle> obstacles(const std::vector<KeptObstacle>& kept) {
  std::vector<SeenObstacle> all;
  all.reserve(kept.size());
  for (const KeptObstacle& k : kept) all.push_back(k.obstacle);
  return all;
}

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
      ledger_{static_cast<std::uint32_t>(settings_.plan.route.centers.size())},
      room_{settings_.avoidance.planned},
      losses_(settings_.plan.route.strips.size(), 0) {
  require(settings_.windows_ahead >= 1, "an agent has a window to work on");
  require(number(settings_.epoch) > 0, "an epoch is counted from 1");
  for (const UavPlan& uav : settings_.plan.uavs) {
    place_of(uav.station, stations_);
    for (const Station& s : uav.landings) place_of(s, stations_);
    Member m{.agent = uav.vehicle.id,
             .vehicle = uav.vehicle,
             .station = uav.station,
             .sorties = orders(settings_.plan.route, uav),
             .pieces = {},
             .lands_s = uav.lands_s,
             .joins = uav.joins_late};
    m.pieces = pieces(m.sorties);
    members_.push_back(std::move(m));
  }
  for (const Station& s : settings_.stations) place_of(s, stations_);
  if (!settings_.separation) return;
  airspace_.emplace(*settings_.separation);
  find_near_work();
}

Outbox SchedulerNode::step(const Inbox& inbox, Instant now) {
  Outbox out;
  if (phase_ != MissionPhase::finished) {
    for (const Envelope& envelope : inbox) hear(envelope, now, out);
    take_orders(now, out);
    keep_time(now);
    close_windows(now, out);
    check_leases(now, out);
    gather(now, out);
    hand_over();
    wind_up(out);
    share_out(now, out);
    welcome(now, out);
    close_stations(now, out);
    plan_for_failed_supply(now, out);
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
  if (const auto* seen = std::get_if<ObstacleSeen>(&envelope.body)) hear(*seen, now, out);
  if (const auto* claim = std::get_if<FlightClaim>(&envelope.body)) hear(*claim, now, out);
  if (const auto* state = std::get_if<StationState>(&envelope.body)) hear(*state, out);
  if (const auto* order = std::get_if<OperatorOrder>(&envelope.body)) hear(*order, out);
}

void SchedulerNode::hear(const AgentInfo& info, Instant now, Outbox&) {
  member(info.agent, info.boot, now);
}

void SchedulerNode::hear(const AgentState& state, Instant now, Outbox& out) {
  Member* m = member(state.agent, state.boot, now);
  if (m == nullptr) return hear_adrift(state, now);
  m->phase = state.phase;
  m->place = {now, state.position, 0.0};
  m->battery = state.battery;
  const bool follows = state.epoch == settings_.epoch && state.revision == m->revision;
  if (follows) m->accepted = true;
  if (state.phase == Phase::offline && has_work_left(*m) && !leaves_on_order(*m)) {
    lose(*m, "it left the fleet", now, out);
    return;
  }
  const bool lacks_grant = state.last_grant < ledger_.last_granted(m->agent);
  const bool lacks_receipt = state.last_closed > ledger_.last_booked(m->agent);
  if (follows && (lacks_grant || lacks_receipt) && is_due(m->granted_at, now)) m->owes_grant = true;
}

void SchedulerNode::hear(const CommandAck& ack, Instant now, Outbox& out) {
  Member* m = member(ack.agent, ack.boot, now);
  if (m == nullptr || ack.epoch != settings_.epoch || ack.revision != m->revision) return;
  switch (ack.status) {
    case AckStatus::accepted:
    case AckStatus::running:
    case AckStatus::done: m->accepted = true; break;
    case AckStatus::rejected:
    case AckStatus::failed:
    case AckStatus::cancelled:
      lose(*m, "it does not follow its order: " + ack.reason, now, out);
      break;
    case AckStatus::received: break;
  }
}

void SchedulerNode::hear(const WorkReport& report, Instant now, Outbox& out) {
  Member* m = member(report.agent, report.boot, now);
  if (m == nullptr || report.epoch != settings_.epoch) return;
  for (const Closure& closure : report.closures) {
    switch (ledger_.book(m->agent, closure)) {
      case Booking::booked:
        m->owes_grant = true;
        if (closure.reason == CloseReason::blocked) {
          cut_blocked(*m, closure.cells.first + closure.sprayed, out);
        }
        break;
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

void SchedulerNode::hear(const ObstacleSeen& seen, Instant now, Outbox& out) {
  const Member* m = member(seen.agent, seen.boot, now);
  if (m == nullptr || seen.epoch != settings_.epoch) return;
  const bool is_known =
      std::any_of(obstacles_.begin(), obstacles_.end(),
                  [&](const KeptObstacle& o) { return o.obstacle == seen.obstacle; });
  if (is_known) return;
  obstacles_.push_back({seen.obstacle, seen.clearance});
  out.messages.push_back(event("obstacle_planned", text(m->agent) + " met an obstacle" +
                                                       text(seen.obstacle) +
                                                       ", which all fly around from now on"));
  foresee_detours(now);
  for (Member& other : members_) {
    if (!is_down(other)) revise(other);
  }
}

/// Ends the gathering once every agent is heard of or lost.
void SchedulerNode::gather(Instant now, Outbox& out) {
  if (phase_ != MissionPhase::gathering) return;
  const bool is_over = now >= Instant{settings_.gather_time};
  for (Member& m : members_) {
    if (!m.boot && !m.lost && !m.joins && is_over) lose(m, "it was never heard of", now, out);
  }
  const bool is_complete = std::all_of(members_.begin(), members_.end(),
                                       [](const Member& m) { return m.boot || m.lost || m.joins; });
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
         now, out);
  }
}

void SchedulerNode::check_limit(Instant now, Outbox& out) {
  if (now < Instant{settings_.mission_limit}) return;
  out.messages.push_back(event("mission_limit", "the mission takes longer than its limit of " +
                                                    std::to_string(seconds(now).base()) + " s"));
  for (const Member& m : members_) forsake(m, "mission_limit", out);
  abandon(whole(ledger_), "mission_limit", out);
  phase_ = MissionPhase::finished;
}

void SchedulerNode::forsake(const Member& m, std::string_view why, Outbox& out) {
  for (const CellRange cells : ledger_.forsake(m.agent)) {
    out.messages.push_back(
        event("cells_uncertain", text(cells) + " of " + text(m.agent) + ": " + std::string{why}));
  }
}

void SchedulerNode::abandon(CellRange cells, std::string_view why, Outbox& out) {
  for (const CellRange run : ledger_.abandon(cells)) {
    out.messages.push_back(event("cells_abandoned", text(run) + ": " + std::string{why}));
  }
}

void SchedulerNode::direct(Member& m, Instant now, Outbox& out) {
  if (m.lost) return;
  if (!m.accepted) {
    if (leaves_on_order(m) || now < instant(m.vehicle.available_from)) return;
    if (is_due(m.commanded_at, now)) command(m, now, out);
    return;
  }
  if (!leaves_on_order(m)) release(m, now);
  if (m.owes_grant) send_grant(m, now, out);
}

void SchedulerNode::command(Member& m, Instant now, Outbox& out) {
  out.messages.push_back(Command{.agent = m.agent,
                                 .target_boot = *m.boot,
                                 .epoch = settings_.epoch,
                                 .revision = m.revision,
                                 .sorties = m.sorties,
                                 .obstacles = obstacles(obstacles_)});
  m.commanded_at = now;
}

/// Opens windows until enough are open, in the order of the list, so the rest of one closed early
/// comes before what lies behind it.
void SchedulerNode::release(Member& m, Instant now) {
  std::size_t open = ledger_.windows(m.agent).size();
  for (const SortieOrder& sortie : m.sorties) {
    for (std::size_t i = 0; i < sortie.pieces.size(); ++i) {
      while (const auto run = ledger_.first_open(sortie.pieces[i].cells)) {
        if (open >= settings_.windows_ahead || now < m.asks_again) return;
        if (!may_begin(m, sortie, i, *run, now)) {
          m.asks_again = now + ask_after;
          return;
        }
        ledger_.grant(m.agent, *run);
        m.owes_grant = true;
        ++open;
      }
    }
  }
}

void SchedulerNode::send_grant(Member& m, Instant now, Outbox& out) {
  out.messages.push_back(WorkGrant{.agent = m.agent,
                                   .target_boot = *m.boot,
                                   .epoch = settings_.epoch,
                                   .revision = m.revision,
                                   .closed_through = ledger_.closed_through(m.agent),
                                   .windows = ledger_.windows(m.agent)});
  m.granted_at = now;
  m.owes_grant = false;
}

bool SchedulerNode::has_work_left(const Member& m) const {
  const auto is_open = [this](const Piece& p) { return ledger_.first_open(p.cells).has_value(); };
  return !ledger_.windows(m.agent).empty() ||
         std::any_of(m.pieces.begin(), m.pieces.end(), is_open);
}

/// Whether an agent is on the ground for good.
bool SchedulerNode::is_down(const Member& m) const {
  const bool stands = m.phase == Phase::done || m.phase == Phase::offline || m.phase == Phase::idle;
  return m.lost || (stands && !has_work_left(m));
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
  state.completed = phase_ == MissionPhase::finished && cells.abandoned == 0;
  for (const Member& m : members_) {
    if (m.lost) state.lost.push_back(m.agent);
  }
  return state;
}

void SchedulerNode::report_state(Instant now, Outbox& out) {
  const bool is_news = reported_phase_ != phase_ || reported_revision_ != level_revision_ ||
                       reported_order_ != answered_order_;
  if (now < state_due_ && !is_news) return;
  if (phase_ == MissionPhase::finished && farewells_-- <= 0) return;
  report_orders(out);
  out.messages.push_back(state());
  reported_phase_ = phase_;
  state_due_ = Instant{(now.time_since_epoch() / state_period + 1) * state_period};
}

Instant SchedulerNode::next_wake(Instant now) const {
  if (phase_ == MissionPhase::finished) return farewells_ > 0 ? state_due_ : never;
  Instant next = std::min(state_due_, Instant{settings_.mission_limit});
  if (phase_ == MissionPhase::gathering) next = std::min(next, Instant{settings_.gather_time});
  if (orders_taken_ < settings_.orders.size()) {
    next = std::min(next, settings_.orders[orders_taken_].at);
  }
  for (const Member& m : members_) {
    if (is_leased(m)) next = std::min(next, m.last_heard + settings_.agent_lease);
    const Instant opens = instant(m.vehicle.available_from);
    if (!m.accepted && opens > now) next = std::min(next, opens);
    if (!m.is_out && called_home(m) > now) next = std::min(next, called_home(m));
  }
  return std::max(next, now + Duration{1});
}

}  // namespace furrow::scheduler
