// How the scheduler moves work from one list to another: of the lost, for who joins late, behind
// what blocks a strip.

#include "core/require.hpp"
#include "scheduler/detours.hpp"
#include "scheduler/events.hpp"
#include "scheduler/orders.hpp"
#include "scheduler/remnant.hpp"
#include "scheduler/scheduler_node.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace furrow::scheduler {
namespace {

constexpr std::uint32_t most_losses = 3;  // on one strip, until nobody is sent there again

/// Whether a station has given away all of its mix or all of its charged packs.
bool has_run_out(const Station& station, const StationState& state) {
  constexpr Volume drop = litres(1e-6);
  return (station.mix && state.filled + drop >= *station.mix) ||
         (station.packs && state.swaps >= *station.packs);
}

}  // namespace

/// Its windows become uncertain, the rest of its list is to be shared out.
void SchedulerNode::lose(Member& m, std::string_view why, Instant now, Outbox& out) {
  out.messages.push_back(event("agent_lost", text(m.agent) + ": " + std::string{why}));
  const auto windows = ledger_.windows(m.agent);
  std::vector<CellRange> open = open_cells(m);
  if (is_at_work(m.phase) && !(windows.empty() && open.empty())) {
    const CellRange at_hand = windows.empty() ? open.front() : windows.front().cells;
    ++losses_[planner::strip_of(settings_.plan.route, at_hand.first)];
  }
  if (airspace_) leave_adrift(m, now);
  forsake(m, "agent_lost", out);
  orphans_.insert(orphans_.end(), open.begin(), open.end());
  m.lost = true;
  m.sorties.clear();
  m.pieces.clear();
}

/// The open cells of its list, in the list's order.
std::vector<CellRange> SchedulerNode::open_cells(const Member& m) const {
  std::vector<CellRange> open;
  for (const Piece& piece : m.pieces) {
    CellRange rest = piece.cells;
    while (const auto run = ledger_.first_open(rest)) {
      open.push_back(*run);
      rest = {end(*run), end(rest) - end(*run)};
    }
  }
  return open;
}

/// Gives the work of lost agents to the others, then what nobody has begun anew to all.
void SchedulerNode::share_out(Instant now, Outbox& out) {
  if (phase_ != MissionPhase::flying || orphans_.empty()) return;
  spare_the_fleet(out);
  const std::vector<CellRange> orphans = joined(std::exchange(orphans_, {}));
  std::vector<Member*> able;
  std::vector<Survivor> survivors;
  for (Member& m : members_) {
    if (!can_take_more(m, now)) continue;
    able.push_back(&m);
    survivors.push_back(survivor(m, now));
  }
  Takeover shared =
      take_over(settings_.plan.route, orphans, survivors, settings_.effort, open_stations());
  for (std::size_t i = 0; i < able.size(); ++i)
    extend(*able[i], std::move(shared.additions[i]), out);
  const std::string_view why =
      able.empty() ? "no aircraft is left" : "out of reach of every aircraft that is left";
  for (const CellRange cells : shared.nobodys) abandon(cells, why, out);
  share_anew(now, out);
}

bool SchedulerNode::can_take_more(const Member& m, Instant now) const {
  const bool is_heard = m.boot && now - m.last_heard < settings_.agent_lease;
  return is_heard && !m.lost && !m.is_out && m.phase != Phase::offline && now < called_home(m);
}

/// Gives those who came late a share of what is left.
void SchedulerNode::welcome(Instant now, Outbox& out) {
  if (phase_ != MissionPhase::flying) return;
  bool is_new = false;
  for (Member& m : members_) {
    if (!m.joins || !m.boot) continue;
    m.joins = false;
    is_new = true;
    out.messages.push_back(event("agent_joined", text(m.agent) + " is there"));
  }
  if (is_new) share_anew(now, out);
}

/// What it says of its queue, of bays that are shut and of its stock; the last two are never
/// mended.
void SchedulerNode::hear(const StationState& state, Outbox& out) {
  const auto known = std::find_if(stations_.begin(), stations_.end(),
                                  [&](const Station& s) { return s.id == state.station; });
  if (known == stations_.end() || shut_.contains(known->id)) return;
  next_free_[known->id] = state.next_free;
  if (has_run_out(*known, state)) {
    shut_.insert(known->id);
    has_supply_failed_ = true;
    out.messages.push_back(event("stock_empty", text(node(known->id)) + " has come to the end of " +
                                                    "its stock and is not planned with any more"));
    return;
  }
  if (state.open_bays >= known->bays) return;
  if (state.open_bays == 0) shut_.insert(known->id);
  known->bays = std::max(state.open_bays, 1U);
  for (Member& m : members_) {
    if (m.station.id == known->id) m.station.bays = known->bays;
  }
  has_supply_failed_ = true;
  out.messages.push_back(event("bays_planned", text(node(known->id)) + " has " +
                                                   std::to_string(state.open_bays) +
                                                   " bays left to plan with"));
}

/// Plans no more with stations that close; anew, where somebody still had to be served there.
void SchedulerNode::close_stations(Instant now, Outbox& out) {
  for (const Station& s : stations_) {
    if (!s.available_until || now < instant(*s.available_until)) continue;
    if (!shut_.insert(s.id).second) continue;
    has_supply_failed_ |= std::any_of(members_.begin(), members_.end(),
                                      [&](const Member& m) { return needs(m, s.id); });
    out.messages.push_back(event("station_closed", text(node(s.id)) + " has closed"));
  }
}

/// Whether it has work left that it is served for at that station.
bool SchedulerNode::needs(const Member& m, StationId at) const {
  bool comes_from_there = false;
  for (const SortieOrder& sortie : m.sorties) {
    const auto is_open = [&](const Piece& p) { return ledger_.first_open(p.cells).has_value(); };
    if (comes_from_there && std::any_of(sortie.pieces.begin(), sortie.pieces.end(), is_open))
      return true;
    comes_from_there = sortie.station == at;
  }
  return false;
}

/// Sends what nobody has begun to stations that are open.
void SchedulerNode::plan_for_failed_supply(Instant now, Outbox& out) {
  if (phase_ != MissionPhase::flying || !has_supply_failed_) return;
  has_supply_failed_ = false;
  if (shut_.size() < stations_.size()) share_anew(now, out, true);
}

std::vector<Station> SchedulerNode::open_stations() const {
  std::vector<Station> open;
  std::copy_if(stations_.begin(), stations_.end(), std::back_inserter(open),
               [this](const Station& s) { return !shut_.contains(s.id); });
  return open;
}

/// The station itself, or the nearest that serves who comes then if it does not; itself if none
/// does.
const Station& SchedulerNode::haven(const Station& wanted, double comes_s) const {
  const auto is_shut = [&](const Station& s) {
    const Seconds begins = std::max(seconds(comes_s), s.available_from);
    return shut_.contains(s.id) || !keeps(s, begins, service_time(s, true, 1.0));
  };
  const Station* nearest = &wanted;
  for (const Station& s : stations_) {
    if (!is_shut(wanted) || is_shut(s)) continue;
    const bool is_nearer = is_shut(*nearest) || distance(s.position, wanted.position) <
                                                    distance(nearest->position, wanted.position);
    if (is_nearer) nearest = &s;
  }
  return *nearest;
}

/// Plans what nobody has begun anew for all, where that ends the mission earlier.
/// @param whatever_it_takes  Also where it does not.
void SchedulerNode::share_anew(Instant now, Outbox& out, bool whatever_it_takes) {
  for (Member& m : members_) {
    if (can_take_more(m, now)) release(m, now);  // so that what comes next counts as begun
  }
  std::vector<Member> revised = members_;  // the old lists stay where they are as good
  std::vector<std::size_t> who;
  std::vector<Survivor> survivors;
  std::vector<CellRange> unbegun;
  double done_before_s = 0.0, done_after_s = 0.0;
  for (std::size_t i = 0; i < revised.size(); ++i) {
    if (!can_take_more(revised[i], now)) continue;
    done_before_s = std::max(done_before_s, done_s(revised[i], now));
    const std::vector<CellRange> back = take_back(revised[i], now);
    unbegun.insert(unbegun.end(), back.begin(), back.end());
    who.push_back(i);
    survivors.push_back(survivor(revised[i], now));
  }
  if (unbegun.empty()) return;
  Takeover shared = take_over(settings_.plan.route, joined(std::move(unbegun)), survivors,
                              settings_.effort, open_stations());
  for (std::size_t i = 0; i < who.size(); ++i) {
    const Addition& added = shared.additions[i];
    const double kept_s = done_s(revised[who[i]], now);
    done_after_s = std::max(done_after_s, added.sorties.empty() ? kept_s : added.lands_s);
  }
  const bool is_worth_it = whatever_it_takes || done_after_s < done_before_s;
  if (!shared.nobodys.empty() || !is_worth_it) return;
  members_ = std::move(revised);
  for (std::size_t i = 0; i < who.size(); ++i) {
    extend(members_[who[i]], std::move(shared.additions[i]), out);
  }
}

/// The metres that ways around obstacles met add to the open cells of its list.
double SchedulerNode::detours_left_m(const Member& m) const {
  const std::vector<planner::MetDetour>& by_cell = settings_.plan.route.detours;
  double sum_m = 0.0;
  if (by_cell.empty()) return sum_m;
  for (const CellRange open : open_cells(m)) {
    for (std::uint32_t c = open.first; c < end(open); ++c) sum_m += by_cell[c].longer_m;
  }
  return sum_m;
}

/// Counts the ways around all obstacles met so far.
void SchedulerNode::foresee_detours(Instant now) {
  const KeptObstacle& met = obstacles_.back();
  const FieldPoint at = met.obstacle.center;
  room_ = room_.with({{{at.x.base(), at.y.base()}, (met.obstacle.radius + met.clearance).base()}});
  std::vector<double> before_m;
  before_m.reserve(members_.size());
  for (const Member& m : members_) before_m.push_back(detours_left_m(m));
  planner::Route& route = settings_.plan.route;
  route.detours =
      detours(route, room_, settings_.avoidance.turn_radius, settings_.avoidance.weights);
  const double now_s = seconds(now.time_since_epoch()).base();
  for (std::size_t i = 0; i < members_.size(); ++i) {
    Member& m = members_[i];
    const double more_m = detours_left_m(m) - before_m[i];
    if (m.lands_s > now_s) m.lands_s += more_m / m.vehicle.spray_speed.base();
  }
}

/// Takes the sorties off the end of its list of which nothing is granted or sprayed.
std::vector<CellRange> SchedulerNode::take_back(Member& m, Instant now) {
  const auto is_open = [&](const Piece& p) { return ledger_.first_open(p.cells) == p.cells; };
  const auto is_unbegun = [&](const SortieOrder& sortie) {
    return std::all_of(sortie.pieces.begin(), sortie.pieces.end(), is_open);
  };
  const std::uint32_t left_before = cells_left(m);
  std::vector<CellRange> back;
  while (!m.sorties.empty() && is_unbegun(m.sorties.back())) {
    for (const Piece& piece : m.sorties.back().pieces) back.push_back(piece.cells);
    m.sorties.pop_back();
  }
  if (back.empty()) return back;
  m.pieces = pieces(m.sorties);
  if (!m.sorties.empty()) m.station = station(m.sorties.back().station);
  const double now_s = seconds(now.time_since_epoch()).base();
  const double share = static_cast<double>(cells_left(m)) / left_before;
  if (m.lands_s > now_s) m.lands_s = now_s + share * (m.lands_s - now_s);
  revise(m);
  return back;
}

/// Gives up what is left of strips at which too many were lost.
void SchedulerNode::spare_the_fleet(Outbox& out) {
  std::vector<CellRange> left;
  for (CellRange rest : orphans_) {
    while (rest.count > 0) {
      const std::size_t s = planner::strip_of(settings_.plan.route, rest.first);
      const std::uint32_t stop = std::min(end(rest), end(settings_.plan.route.strips[s].cells));
      const CellRange part{rest.first, stop - rest.first};
      rest = {stop, end(rest) - stop};
      if (losses_[s] < most_losses) {
        left.push_back(part);
      } else {
        abandon(part, std::to_string(losses_[s]) + " aircraft were lost on this strip", out);
      }
    }
  }
  orphans_ = std::move(left);
}

const Station& SchedulerNode::station(StationId id) const {
  const auto known = std::find_if(stations_.begin(), stations_.end(),
                                  [id](const Station& s) { return s.id == id; });
  require(known != stations_.end(), "sorties end at stations of the plan");
  return *known;
}

std::uint32_t SchedulerNode::cells_left(const Member& m) const {
  std::uint32_t left = 0;
  for (const CellRange open : open_cells(m)) left += open.count;
  for (const GrantWindow& window : ledger_.windows(m.agent)) left += window.cells.count;
  return left;
}

/// When it is done with its list, as forecast, or as what is left takes at least.
double SchedulerNode::done_s(const Member& m, Instant now) const {
  const double now_s = seconds(now.time_since_epoch()).base();
  const std::uint32_t left = cells_left(m);
  if (left == 0) return now_s;
  const Seconds least =
      (static_cast<double>(left) * settings_.plan.route.cell) / m.vehicle.spray_speed;
  return std::max(m.lands_s, now_s + least.base());
}

/// When a bay is free for one who is at a station then, as far as the station has said.
double SchedulerNode::bay_free_s(const Station& at, double arrives_s) const {
  const double there_s = std::max(arrives_s, at.available_from.base());
  const auto said = next_free_.find(at.id);
  return said == next_free_.end() ? there_s : std::max(there_s, seconds(said->second).base());
}

/// Done with its list, and served after those who wait there already.
Survivor SchedulerNode::survivor(const Member& m, Instant now) const {
  Survivor s{.vehicle = m.vehicle,
             .station = haven(m.station, done_s(m, now)),
             .ready_s = std::max(seconds(now.time_since_epoch()), m.vehicle.available_from).base()};
  if (m.pieces.empty()) return s;
  s.vehicle.home = s.station.position;
  s.ready_s = bay_free_s(s.station, done_s(m, now)) + service_time(s.station, true, 1.0).base();
  return s;
}

void SchedulerNode::extend(Member& m, Addition added, Outbox& out) {
  if (added.sorties.empty()) return;
  std::uint32_t cells = 0;
  for (Piece& piece : pieces(added.sorties)) {
    cells += piece.cells.count;
    m.pieces.push_back(std::move(piece));
  }
  out.messages.push_back(event(
      "work_taken_over", text(m.agent) + " takes over " + std::to_string(cells) + " cells in " +
                             std::to_string(added.sorties.size()) + " sorties"));
  std::move(added.sorties.begin(), added.sorties.end(), std::back_inserter(m.sorties));
  m.station = added.station;
  m.lands_s = added.lands_s;
  revise(m);
}

/// Its command has changed.
void SchedulerNode::revise(Member& m) {
  if (m.commanded_at) ++m.revision;
  m.accepted = false;
  m.commanded_at.reset();
}

/// Takes cells that an obstacle blocks out of the list; what lies behind them is a piece of its
/// own.
void SchedulerNode::cut_blocked(Member& m, std::uint32_t first, Outbox& out) {
  const auto blocked =
      furrow::scheduler::cut_blocked(settings_.plan.route, m.sorties, first, obstacles_);
  if (!blocked) return;
  abandon(*blocked, "an obstacle stands there, with no room for a detour", out);
  m.pieces = pieces(m.sorties);
  revise(m);
}

}  // namespace furrow::scheduler
