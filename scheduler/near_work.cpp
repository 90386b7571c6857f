// Work that lies so near to other work that one aircraft at a time is at it.

#include "planner/coverage/plane.hpp"
#include "scheduler/near_strips.hpp"
#include "scheduler/scheduler_node.hpp"

#include <algorithm>

namespace furrow::scheduler {
namespace {

constexpr double room_m = 1.0;              // each of two is within 0.5 m of its line
constexpr double most_room = 0.2;           // of a swath, so that neighbouring strips are apart
constexpr double place_m = 1.0;             // how far off a hovering aircraft's fix may be
constexpr Seconds comes_soon = seconds(8);  // long enough to be granted and not to have to brake

planner::PointM plane(FieldPoint p) { return {p.x.base(), p.y.base()}; }

}  // namespace

/// How near to other work is too near for two.
Length SchedulerNode::near_work() const {
  Length room = metres(room_m);
  for (const Member& m : members_) room = std::min(room, most_room * m.vehicle.swath);
  return *settings_.separation + room;
}

void SchedulerNode::find_near_work() {
  near_m_ = near_work().base();
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
      piece == 0 || planner::are_apart(sortie.pieces[piece - 1], sortie.pieces[piece]);
  const bool flies_there = comes_by_way ? m.phase != Phase::hold : !is_at_work(m.phase);
  if (flies_there) return comes_by_way || ledger_.windows(m.agent).empty();
  return comes_soon_to_next(m) && is_free(m, line(cells), now) &&
         (comes_by_way || is_clear_of_ways(m, sortie.pieces[piece]));
}

/// Whether nobody else is at work near that to which a way leads.
bool SchedulerNode::is_free(const Member& m, CellRange leads_to, Instant now) const {
  if (leads_to.count == 0) return true;
  const std::vector<Piece> work = work_from(m, leads_to.first);
  return std::all_of(work.begin(), work.end(), [&](const Piece& p) {
    return !is_shared(p.cells) || is_free(m, {plane(p.entry), plane(p.exit)}, now);
  });
}

bool SchedulerNode::is_free(const Member& m, const Line& at, Instant now) const {
  return std::none_of(members_.begin(), members_.end(), [&](const Member& other) {
    return other.agent != m.agent && is_near(other, at, now);
  });
}

bool SchedulerNode::comes_soon_to_next(const Member& m) const {
  const auto windows = ledger_.windows(m.agent);
  if (windows.empty()) return true;
  const planner::PointM last = line(windows.back().cells).to;
  return planner::norm(last - plane(m.place.position)) <
         (comes_soon * m.vehicle.spray_speed).base();
}

/// Whether an agent is or comes to work near a line, or hovers there.
bool SchedulerNode::is_near(const Member& m, const Line& at, Instant now) const {
  const auto its = at_work(m, now);
  if (!its) return false;
  const bool works_near = std::any_of(its->ahead.begin(), its->ahead.end(), [&](const Piece& p) {
    return planner::apart_m(at.from, at.to, plane(p.entry), plane(p.exit)) < near_m_;
  });
  const bool is_there = is_at_work(m.phase) || !airspace_->arrival(m.agent, now);
  return works_near || (is_there && planner::distance_m(plane(m.place.position), at.from, at.to) <
                                        near_m_ + place_m);
}

/// Whether no low way that was given before meets it there.
bool SchedulerNode::is_clear_of_ways(const Member& m, const Piece& next) const {
  std::vector<Piece> ahead = work_ahead(m);
  ahead.push_back(next);
  std::vector<WorkSite> sites;
  add_work(m, m.place, ahead, sites);
  return airspace_->is_clear(sites);
}

}  // namespace furrow::scheduler
