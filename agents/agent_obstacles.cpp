#include "agents/agent_node.hpp"
#include "agents/text.hpp"

#include <algorithm>
#include <utility>

namespace furrow::agents {
namespace {

constexpr double there_m = 0.1;  // an aircraft at rest is at its stop, within this

std::string text(const SeenObstacle& o) {
  return "an obstacle of " + fixed(o.radius.base(), 1) + " m at (" + fixed(o.center.x.base(), 1) +
         ", " + fixed(o.center.y.base(), 1) + ") m";
}

}  // namespace

// What it sees it flies around from this very period on.
void AgentNode::look_out(Instant t) {
  bool is_news = false;
  for (const SeenObstacle& o : lookout_.sees(aircraft_.truth_m(), t)) {
    if (!around_.learn(o)) continue;
    is_news = true;
    note("obstacle_seen", "sees " + text(o));
    sightings_.push_back(o);
  }
  if (!is_news) return;
  report_obstacles();
  reroute(t);
}

void AgentNode::report_obstacles() {
  if (!order_) return;
  const auto& known = order_->obstacles();
  std::erase_if(sightings_, [&](const SeenObstacle& o) {
    return std::find(known.begin(), known.end(), o) != known.end();
  });
  for (const SeenObstacle& o : sightings_) {
    send(ObstacleSeen{.agent = vehicle_.id,
                      .boot = settings_.boot,
                      .epoch = order_->epoch(),
                      .revision = order_->revision(),
                      .obstacle = o,
                      .clearance = around_.clearance()});
  }
}

// Lays the same route again, around what has been learnt since. Where the aircraft is beyond the
// point at which the new one turns off, or too fast for it, it stops and goes on from there.
void AgentNode::reroute(Instant t) {
  const bool hovers_without_way = phase_ == Phase::hold && route_->pieces.empty();
  if (is_astray_ || hovers_without_way) return;
  std::vector<Piece> pieces;
  pieces.reserve(route_->pieces.size());
  for (const PieceOnPath& p : route_->pieces) pieces.push_back(p.piece);
  SortieRoute next = lay(laid_from_m_, pieces, metres(laid_altitude_m_));
  const bool is_same =
      next.path.segments() == route_->path.segments() && next.blocked_m == route_->blocked_m;
  if (is_same) return;
  if (aircraft_.leads_on(next.path)) return swerve(std::move(next));
  stop_short(t);
}

void AgentNode::swerve(SortieRoute route) {
  spray_left_m_ += route.spray_m - route_->spray_m;
  note_outside(route);
  route_ = std::move(route);
  aircraft_.redirect(route_->path);
  announce_way();
  expect_next_cell();
  if (phase_ == Phase::hold) return;  // stays where it is
  if (awaits_way()) return;
  if (phase_ == Phase::fly_back) {
    stop_m_ = before_blockage_m(no_stop);
  } else if (leaving_) {
    stop_m_ = no_stop;
    stop_m_ = before_blockage_m(leaving_stop_m());
  } else {
    stop_m_ = before_blockage_m(licensed_stop_m());
    if (!may_work()) stop_m_ = leaving_stop_m();
  }
}

// Once, until a route stays on the land again.
void AgentNode::note_outside(const SortieRoute& route) {
  const bool is_known = std::exchange(leaves_land_, route.leaves_land);
  if (!route.leaves_land || is_known) return;
  note("land_left", "flies around an obstacle outside the field: no way leads past it inside");
}

void AgentNode::stop_short(Instant t) {
  const Pace& pace = aircraft_.pilot().pace();
  note("obstacle_near", "is too near for a way around and stops");
  if (is_valve_open_) move_valve(false, t);
  stop_m_ = std::min(stop_m_, pace.along_m() + pace.braking_m());
  if (leaving_) return;
  flush_flight_log();
  is_astray_ = true;
  has_strayed_ = false;
  if (phase_ != Phase::fly_back) phase_ = Phase::hold;
}

double AgentNode::before_blockage_m(double stop_m) const {
  return std::min(stop_m, route_->blocked_m.value_or(no_stop));
}

// Whether it has come to rest where there is no way on.
bool AgentNode::is_blocked() const {
  return route_->blocked_m && phase_ != Phase::hold && stop_m_ > *route_->blocked_m - there_m;
}

// Holds and gives its windows back: the scheduler knows what to do with the rest.
void AgentNode::meet_blockage(Instant t) {
  if (phase_ == Phase::fly_back) return;  // nobody can help it
  phase_ = Phase::hold;
  if (is_valve_open_) move_valve(false, t);
  flush_flight_log();
  note("way_blocked", "holds before cell " + std::to_string(order_->next_cell()) +
                          ": an obstacle leaves no way around");
  ledger_.close_blocked(order_->next_cell(), t);
  next_report_ = t;
  forget_way();
}

}  // namespace furrow::agents
