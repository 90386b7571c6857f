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

bool contains(CellRange cells, std::uint32_t cell) {
  return cell >= cells.first && cell < end(cells);
}

}  // namespace

void SchedulerNode::hear(const FlightClaim& claim, Instant now, Outbox& out) {
  Member* claimant = member(claim.agent, claim.boot, now);
  const bool is_way_home = claim.departure != Departure::from_ground && claim.leads_to.count == 0;
  if (claimant == nullptr && is_way_home) claimant = lost_member(claim.agent, claim.boot);
  if (claimant == nullptr || claim.track.size() < 2) return;
  if (claim.departure == Departure::from_hover) {
    claimant->place = {now, claim.track.front().position, 0.0};
  }
  if (!airspace_) {
    const Instant departs = std::max(now, claim.track.front().at);
    out.messages.push_back(FlightGrant{claim.agent, claim.boot, claim.claim, true, departs});
  } else if (auto grant = airspace_->answer(claim, work_sites(*claimant, claim, now),
                                            kept_from_near_work(*claimant, claim.leads_to), now)) {
    out.messages.push_back(*grant);
    if (claimant->lost) expect_home(*claimant, now);
  }
}

std::vector<WorkSite> SchedulerNode::work_sites(const Member& claimant, const FlightClaim& claim,
                                                Instant now) const {
  std::vector<WorkSite> sites;
  // Who hovers to go home does not wait for one that may be dead: it would for a whole pack.
  const bool waits_for_lost = claim.departure != Departure::from_hover || claim.leads_to.count > 0;
  for (const Member& m : members_) {
    if (m.agent != claimant.agent && (waits_for_lost || !m.lost)) add_sites(m, now, sites);
  }
  add_work_after(claimant, claim.track.back(), claim.leads_to, sites);
  return sites;
}

// What an agent works at or comes to. Who is on its way home hovers, until that is its own.
std::optional<SchedulerNode::AtWork> SchedulerNode::at_work(const Member& m, Instant now) const {
  if (m.lost) return at_work_adrift(m, now);
  const auto arrives = airspace_->arrival(m.agent, now);
  const bool is_on_way = arrives && m.phase != Phase::hold &&
                         (m.phase != Phase::fly_back || arrives->leads_to.count == 0);
  if (is_on_way) {
    if (arrives->leads_to.count == 0) return std::nullopt;
    return AtWork{arrives->place, work_from(m, arrives->leads_to.first)};
  }
  if (is_at_work(m.phase)) return AtWork{m.place, work_ahead(m)};
  if (m.phase == Phase::fly_back) return AtWork{m.place, {}};
  return std::nullopt;
}

// Where and when an agent is or will be at work, up to its next way.
void SchedulerNode::add_sites(const Member& m, Instant now, std::vector<WorkSite>& sites) const {
  if (m.lost) return add_adrift(m, now, sites);
  const auto its = at_work(m, now);
  if (!its) return;
  const std::size_t first = sites.size();
  add_work(m, its->from, its->ahead, sites);
  if (m.phase != Phase::hold) return;
  for (std::size_t i = first; i < sites.size(); ++i) sites[i].leaves = never;
}

void SchedulerNode::add_work_after(const Member& m, const TimedPlace& arrives, CellRange leads_to,
                                   std::vector<WorkSite>& sites) const {
  if (leads_to.count > 0) add_work(m, arrives, work_from(m, leads_to.first), sites);
}

// It is nowhere sooner than at full speed; where it turns or brakes it comes later. At its end it
// may hover for as long as it takes until its way is its own.
void SchedulerNode::add_work(const Member& m, TimedPlace from, const std::vector<Piece>& pieces,
                             std::vector<WorkSite>& sites) const {
  const Speed work = m.vehicle.spray_speed, way = m.vehicle.ferry_speed;
  const Instant ends = from.at + horizon;
  add_site(m.agent, from, from.position, work, sites);
  for (const Piece& piece : pieces) {
    const bool is_first = &piece == &pieces.front();
    const FieldPoint enters =
        is_first ? nearest(from.position, piece.entry, piece.exit) : piece.entry;
    add_site(m.agent, from, enters, way, sites);
    add_site(m.agent, from, piece.exit, work, sites);
    if (from.at > ends) return;
  }
  add_site(m.agent, from, from.position, work, sites);
  sites.back().leaves = never;
}

// The pieces of its sortie that are not done, up to the next way, the first from where it is not.
// None where it is before a way.
std::vector<Piece> SchedulerNode::work_ahead(const Member& m) const {
  for (const SortieOrder& sortie : m.sorties) {
    for (std::size_t i = 0; i < sortie.pieces.size(); ++i) {
      const Piece& piece = sortie.pieces[i];
      const auto left = first_left(piece);
      if (!left) continue;
      const Piece* before = i > 0 && *left == piece.cells.first ? &sortie.pieces[i - 1] : nullptr;
      const bool is_before_way =
          before != nullptr && planner::are_apart(*before, piece, swath_) &&
          distance(m.place.position, before->exit) < distance(m.place.position, piece.entry);
      return is_before_way ? std::vector<Piece>{} : up_to_way(sortie, i);
    }
  }
  return {};
}

// The same from a cell on.
std::vector<Piece> SchedulerNode::work_from(const Member& m, std::uint32_t cell) const {
  for (const SortieOrder& sortie : m.sorties) {
    for (std::size_t i = 0; i < sortie.pieces.size(); ++i) {
      if (contains(sortie.pieces[i].cells, cell)) return up_to_way(sortie, i);
    }
  }
  return {};
}

std::vector<Piece> SchedulerNode::up_to_way(const SortieOrder& sortie, std::size_t first) const {
  std::vector<Piece> pieces;
  for (std::size_t i = first; i < sortie.pieces.size(); ++i) {
    Piece piece = sortie.pieces[i];
    if (i > first && planner::are_apart(sortie.pieces[i - 1], piece, swath_)) break;
    const auto left = first_left(piece);
    if (!left) continue;
    const bool is_open = ledger_.state(*left) == CellState::open;
    if (is_open && is_shared({*left, end(piece.cells) - *left})) break;  // it may have to wait
    if (*left > piece.cells.first) piece.entry = settings_.plan.route.centers[*left];
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

std::optional<std::uint32_t> SchedulerNode::first_left(const Piece& piece) const {
  for (std::uint32_t cell = piece.cells.first; cell < end(piece.cells); ++cell) {
    const CellState state = ledger_.state(cell);
    if (state == CellState::open || state == CellState::granted) return cell;
  }
  return std::nullopt;
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
