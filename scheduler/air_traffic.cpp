#include "planner/coverage/plane.hpp"
#include "scheduler/scheduler_node.hpp"

#include <algorithm>
#include <cmath>

namespace furrow::scheduler {
namespace {

constexpr double site_m = 10.0;  // of work, that is taken for one site
constexpr Duration early = std::chrono::seconds{2}, late = std::chrono::seconds{8};
constexpr Duration horizon = std::chrono::minutes{5};  // of flights and their delay

FieldPoint nearest(FieldPoint p, FieldPoint from, FieldPoint to) {
  const auto plane = [](FieldPoint at) { return planner::PointM{at.x.base(), at.y.base()}; };
  const planner::PointM on = planner::nearest_on(plane(p), plane(from), plane(to));
  return at_m(on.x, on.y);
}

}  // namespace

void SchedulerNode::hear(const FlightClaim& claim, Instant now, Outbox& out) {
  if (member(claim.agent, claim.boot, now) == nullptr || claim.track.size() < 2) return;
  if (!airspace_) {
    const Instant departs = std::max(now, claim.track.front().at);
    out.messages.push_back(FlightGrant{claim.agent, claim.boot, claim.claim, true, departs});
  } else if (auto grant = airspace_->answer(claim, work_sites(now), now)) {
    out.messages.push_back(*grant);
  }
}

std::vector<WorkSite> SchedulerNode::work_sites(Instant now) const {
  std::vector<WorkSite> sites;
  for (const Member& m : members_) {
    if (!m.lost) add_sites(m, now, sites);
  }
  return sites;
}

// Where and when an agent is or will be at work. Until its way home is its own it may hover at the
// end of its work for as long as it takes.
void SchedulerNode::add_sites(const Member& m, Instant now, std::vector<WorkSite>& sites) const {
  const auto arrives = airspace_->arrival(m.agent, now);
  const std::size_t first = sites.size();
  const bool is_at_work = m.phase == Phase::spray || m.phase == Phase::hold;
  const bool flies_home =
      arrives && (m.phase == Phase::fly_back || arrives->departure == Departure::in_motion);
  if (is_at_work) {
    add_work(m, m.place, now, sites);
  } else if (m.phase == Phase::fly_back) {
    TimedPlace here = m.place;
    if (!flies_home) add_site(m.agent, here, here.position, m.vehicle.ferry_speed, sites);
  } else if (arrives) {
    add_work(m, arrives->place, now, sites);
  }
  if (sites.size() == first) return;
  if (!flies_home) sites.back().leaves = never;
  if (m.phase != Phase::hold) return;
  for (std::size_t i = first; i < sites.size(); ++i) sites[i].leaves = never;
}

// It is nowhere sooner than at full speed; where it turns or brakes it comes later.
void SchedulerNode::add_work(const Member& m, TimedPlace from, Instant now,
                             std::vector<WorkSite>& sites) const {
  const std::vector<Piece> rest = rest_of_sortie(m);
  const Speed work = m.vehicle.spray_speed, way = m.vehicle.ferry_speed;
  add_site(m.agent, from, from.position, work, sites);
  for (const Piece& piece : rest) {
    const bool is_first = &piece == &rest.front();
    const FieldPoint enters =
        is_first ? nearest(from.position, piece.entry, piece.exit) : piece.entry;
    add_site(m.agent, from, enters, way, sites);
    add_site(m.agent, from, piece.exit, work, sites);
    if (from.at > now + horizon) return;
  }
  add_site(m.agent, from, from.position, work, sites);
}

// The pieces of its sortie that are not done, the first from where it is not.
std::vector<Piece> SchedulerNode::rest_of_sortie(const Member& m) const {
  const auto is_left = [this](std::uint32_t cell) {
    const CellState state = ledger_.state(cell);
    return state == CellState::open || state == CellState::granted;
  };
  std::vector<Piece> rest;
  for (const SortieOrder& sortie : m.sorties) {
    for (Piece piece : sortie.pieces) {
      std::uint32_t cell = piece.cells.first;
      while (cell < end(piece.cells) && !is_left(cell)) ++cell;
      if (cell == end(piece.cells)) continue;
      if (cell > piece.cells.first) piece.entry = settings_.plan.route.centers[cell];
      rest.push_back(piece);
    }
    if (!rest.empty()) break;
  }
  return rest;
}

void SchedulerNode::add_site(AgentId agent, TimedPlace& from, FieldPoint to, Speed speed,
                             std::vector<WorkSite>& sites) const {
  const Length length = distance(from.position, to);
  const int n = std::max(1, static_cast<int>(std::ceil(length.base() / site_m)));
  const FieldVector part{(1.0 / n) * (to.x - from.position.x),
                         (1.0 / n) * (to.y - from.position.y)};
  const Duration takes = duration((1.0 / n) * (length / speed));
  for (int i = 0; i < n; ++i) {
    const FieldPoint next = from.position + part;
    sites.push_back({agent, from.position, next, work_altitude_m(from.position), from.at - early,
                     from.at + takes + late});
    from = {from.at + takes, next, 0.0};
  }
}

double SchedulerNode::work_altitude_m(FieldPoint at) const {
  const planner::Relief* relief = settings_.plan.route.ferries.relief();
  return relief == nullptr ? 0.0 : relief->work_altitude_m(at);
}

}  // namespace furrow::scheduler
