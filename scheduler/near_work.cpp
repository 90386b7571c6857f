// Work that lies so near to other work that one aircraft at a time is at it.

#include "planner/coverage/plane.hpp"
#include "scheduler/near_strips.hpp"
#include "scheduler/scheduler_node.hpp"

#include <algorithm>

namespace furrow::scheduler {
namespace {

constexpr Seconds comes_soon = seconds(8);  // long enough to be granted and not to have to brake

planner::PointM plane(FieldPoint p) { return {p.x.base(), p.y.base()}; }

}  // namespace

void SchedulerNode::find_near_work() {
  swath_ = members_.empty() ? Length{} : members_.front().vehicle.swath;
  for (const Member& m : members_) swath_ = std::min(swath_, m.vehicle.swath);
  near_m_ = near_work(*settings_.separation, swath_).base();
  is_near_others_ = strips_near_others(settings_.plan.route, metres(near_m_));
}

/// Whether one aircraft at a time may be at work on cells of a strip, or beside them.
bool SchedulerNode::is_shared(CellRange cells) const {
  if (!airspace_) return false;
  const std::size_t s = planner::strip_of(settings_.plan.route, cells.first);
  return is_near_others_[s] || cells.count < settings_.plan.route.strips[s].cells.count;
}

SchedulerNode::Line SchedulerNode::line(CellRange cells) const {
  const planner::Route& route = settings_.plan.route;
  const planner::Strip& strip = route.strips[planner::strip_of(route, cells.first)];
  return {plane(planner::start_point(route, strip, cells.first)),
          plane(planner::stop_point(route, strip, end(cells) - 1))};
}

/// Whether cells of a piece of its list can be granted: where others must not be near, once it
/// comes to them and nobody else is there. Those that a way leads to are kept by the way's claim.
bool SchedulerNode::may_begin(const Member& m, const SortieOrder& sortie, std::size_t piece,
                              CellRange cells, Instant now) const {
  if (!is_shared(cells)) return true;
  const bool comes_by_way =
      piece == 0 || planner::are_apart(sortie.pieces[piece - 1], sortie.pieces[piece], swath_);
  const bool flies_there = comes_by_way ? m.phase != Phase::hold : !is_at_work(m.phase);
  if (flies_there) return comes_by_way || ledger_.windows(m.agent).empty();
  return comes_soon_to_next(m) && is_clear(m, sortie.pieces[piece], cells, now);
}

/// Nearer than this to others' work must not be, at the same time, that to which a way leads.
Length SchedulerNode::kept_from_near_work(const Member& m, CellRange leads_to) const {
  if (leads_to.count == 0) return {};
  const std::vector<Piece> work = work_from(m, leads_to.first);
  const bool is_any_shared =
      std::any_of(work.begin(), work.end(), [this](const Piece& p) { return is_shared(p.cells); });
  return is_any_shared ? metres(near_m_) : Length{};
}

bool SchedulerNode::comes_soon_to_next(const Member& m) const {
  const auto windows = ledger_.windows(m.agent);
  if (windows.empty()) return true;
  const planner::PointM last = line(windows.back().cells).to;
  return planner::norm(last - plane(m.place.position)) <
         (comes_soon * m.vehicle.spray_speed).base();
}

/// Whether cells of a piece, next after what it is at, are clear of others' work and of low ways
/// that were given before.
bool SchedulerNode::is_clear(const Member& m, Piece next, CellRange cells, Instant now) const {
  const Line its = line(cells);
  next.entry = at_m(its.from.x, its.from.y);
  std::vector<Piece> ahead = work_ahead(m);
  ahead.push_back(std::move(next));
  std::vector<WorkSite> own, others;
  add_work(m, m.place, ahead, own);
  for (const Member& other : members_) {
    if (other.agent != m.agent) add_sites(other, now, others);
  }
  return airspace_->is_clear(own, others, metres(near_m_), now);
}

}  // namespace furrow::scheduler
