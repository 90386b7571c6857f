// The air of lost aircraft, which may fly on: nobody knows but they.

#include "scheduler/scheduler_node.hpp"

#include <algorithm>

namespace furrow::scheduler {
namespace {

constexpr Duration lag = std::chrono::seconds{8};  // of flights behind what was claimed
constexpr double above_all_m = 1e4;
constexpr double detour = 2.0;  // of the last way home, at most
constexpr Duration early = std::chrono::seconds{30};

}  // namespace

SchedulerNode::Member* SchedulerNode::lost_member(AgentId agent, BootId boot) {
  const auto it = std::find_if(members_.begin(), members_.end(),
                               [&](const Member& m) { return m.agent == agent && m.lost; });
  return it == members_.end() || it->boot != boot ? nullptr : &*it;
}

/// Keeps of what it was given what it may still fly, before that is taken from it.
void SchedulerNode::leave_adrift(Member& m, Instant now) {
  const auto its = at_work(m, now);
  const bool may_fly = its || airspace_->arrival(m.agent, now);
  m.down_by = now;
  if (!may_fly) return;
  const bool is_flying = is_in_air(m.phase);
  m.down_by = (is_flying ? m.place.at : now) +
              duration((is_flying ? m.battery : 1.0) * m.vehicle.flight_endurance);
  if (its) m.place = its->from;  // the end of a way that it was given
  for (const Piece& piece : its ? its->ahead : std::vector<Piece>{}) {
    const auto left = first_left(piece);
    if (left && ledger_.state(*left) == CellState::granted) m.adrift.push_back(piece);
  }
  const auto under_way =
      std::find_if(m.sorties.begin(), m.sorties.end(), [this](const SortieOrder& sortie) {
        return std::any_of(sortie.pieces.begin(), sortie.pieces.end(),
                           [this](const Piece& p) { return first_left(p).has_value(); });
      });
  if (under_way != m.sorties.end()) m.station = station(under_way->station);
  expect_home(m, now);
}

void SchedulerNode::hear_adrift(const AgentState& state, Instant now) {
  Member* m = airspace_ ? lost_member(state.agent, state.boot) : nullptr;
  if (m == nullptr) return;
  m->phase = state.phase;
  m->place = {now, state.position, 0.0};
  m->battery = state.battery;
  if (!is_at_work(m->phase)) m->adrift.clear();
  m->down_by = now;
  if (!is_in_air(m->phase)) return;
  m->down_by += duration(m->battery * m->vehicle.flight_endurance);
  const auto arrives = airspace_->arrival(m->agent, now);
  if (m->phase == Phase::fly_out && arrives) m->place = arrives->place;
  expect_home(*m, now);
}

/// Once it has been given a way home it is down at its end.
void SchedulerNode::expect_home(Member& m, Instant now) {
  const auto arrives = airspace_->arrival(m.agent, now);
  if (!arrives || arrives->leads_to.count > 0) return;
  m.down_by = std::min(m.down_by, arrives->place.at + lag);
}

/// None where it flies a way home that it was given, or is down.
std::optional<SchedulerNode::AtWork> SchedulerNode::at_work_adrift(const Member& m,
                                                                   Instant now) const {
  const auto arrives = airspace_->arrival(m.agent, now);
  if (now >= m.down_by || (arrives && arrives->leads_to.count == 0)) return std::nullopt;
  return AtWork{m.place, m.adrift};
}

/// It may hover anywhere along its work until its pack is only just enough for the way home, and
/// flies that at any height.
void SchedulerNode::add_adrift(const Member& m, Instant now, std::vector<WorkSite>& sites) const {
  const auto its = at_work_adrift(m, now);
  if (!its) return;
  const std::size_t first = sites.size();
  add_work(m, {now, its->from.position, 0.0}, its->ahead, sites);
  for (std::size_t i = first; i < sites.size(); ++i) sites[i].leaves = m.down_by;
  const FieldPoint last = its->ahead.empty() ? its->from.position : its->ahead.back().exit;
  const auto way = settings_.plan.route.ferries.ferry_way(last, m.station.position, m.vehicle);
  Length length{};
  for (std::size_t i = 1; i < way.size(); ++i) length += distance(way[i - 1], way[i]);
  const Instant leaves = m.down_by - early - duration(detour * (length / m.vehicle.ferry_speed));
  for (std::size_t i = 1; i < way.size(); ++i) {
    sites.push_back({m.agent, way[i - 1], way[i], above_all_m, leaves, m.down_by});
  }
}

}  // namespace furrow::scheduler
