#include "agents/agent_node.hpp"
#include "agents/control_clock.hpp"
#include "agents/text.hpp"

#include <algorithm>
#include <utility>

namespace furrow::agents {
namespace {

constexpr double hover_m = 0.5;        // a hovering aircraft is where it means to be, within this
constexpr double tank_slack_m = 1e-3;  // rounding of a tank filled to the very metre
constexpr double hover_slack_s = 4.0;  // until others are out of the way
constexpr int most_strays = 3;         // from one cell, until it gives up

}  // namespace

bool AgentNode::is_airborne() const {
  return phase_ == Phase::fly_out || phase_ == Phase::spray || phase_ == Phase::hold ||
         phase_ == Phase::fly_back;
}

void AgentNode::fly_one_period(Instant t) {
  if (settings_.airspace) mind_traffic(last_tick_);
  last_tick_ = t;
  truth_before_m_ = aircraft_.truth_m();
  aircraft_.fly(stop_m_);
  look_out(t);
  if (!route_->heights.is_level()) keep_height();
  if (route_piece_ < route_->pieces.size()) work(t);
  note_place(t);
  if (aircraft_.stores.pack_share <= 0.0) return fall(t);
  if (phase_ != Phase::fly_back) watch_stores(t);
  // What blew it off its line may not let it hover either.
  const bool has_braked = is_astray_ && aircraft_.pilot().pace().is_at_rest();
  if (aircraft_.is_at_rest(stop_m_) || has_braked) come_to_rest(t);
}

void AgentNode::keep_height() {
  const double wanted_m = route_->heights.altitude_m(aircraft_.along_m());
  climb_s_ += aircraft_.climb_to(wanted_m, height_rule());
}

void AgentNode::note_place(Instant t) {
  if (t == on_grid(t, whole_second)) {
    log_.point(t, aircraft_.truth_m(), aircraft_.altitude_m(), is_valve_open_, open_width());
  } else {
    log_.pass(t, aircraft_.truth_m(), aircraft_.altitude_m(), is_valve_open_, open_width());
  }
}

// Sprays what lies between the last position along the path and this one.
void AgentNode::work(Instant t) {
  if (is_astray_) return;
  double reached_m = aircraft_.along_m();
  if (aircraft_.is_at_rest(stop_m_) && reached_m > stop_m_ - hover_m) reached_m = stop_m_;
  reached_m = std::clamp(reached_m, progress_m_, std::max(stop_m_, progress_m_));

  const PieceOnPath& piece = route_->pieces[route_piece_];
  if (phase_ == Phase::fly_out && reached_m >= piece.open_m) {
    flush_flight_log();
    phase_ = Phase::spray;
  }
  const bool would_spray = reached_m >= piece.open_m && progress_m_ < stop_m_;
  if (would_spray && is_off_line()) return stray(t);
  const bool is_on_strip = reached_m > piece.from_m && !piece.is_beside_its_line(reached_m);
  if (is_valve_open_ && is_on_strip && aircraft_.pilot().segment().is_straight()) {
    log_.sample(piece.piece, aircraft_);
  }
  const double before_m = progress_m_;
  const double closes_m = std::min(piece.valve_moves_m(before_m, reached_m), stop_m_);
  note_detour(piece, before_m, reached_m);
  pass_cells(reached_m, t);
  progress_m_ = reached_m;

  const bool is_open = route_piece_ < route_->pieces.size() && reached_m < stop_m_ &&
                       route_->pieces[route_piece_].is_sprayed(reached_m);
  if (is_open != is_valve_open_) {
    const double at_m =
        is_open ? route_->pieces[route_piece_].valve_moves_m(before_m, reached_m) : closes_m;
    const double moved_m = reached_m - before_m;
    move_valve(is_open, t, moved_m > 0.0 ? std::clamp((at_m - before_m) / moved_m, 0.0, 1.0) : 1.0);
  }
  if (phase_ == Phase::fly_back) flush_flight_log();
}

// Once it is past an obstacle that no plan knew.
void AgentNode::note_detour(const PieceOnPath& piece, double before_m, double reached_m) {
  const bool is_past = before_m < piece.bends_to_m && reached_m >= piece.bends_to_m;
  if (!piece.is_bent() || !is_past) return;
  double closed_m = 0.0;
  for (const PieceOnPath::Closed& c : piece.closed) closed_m += c.to_m - c.from_m;
  if (closed_m > 0.0) {
    note("detour_closed", "flew around what it met, " + fixed(closed_m, 1) + " m valve closed");
  } else {
    note("detour_sprayed", "flew around what it met, valve open");
  }
}

void AgentNode::pass_cells(double reached_m, Instant t) {
  while (route_piece_ < route_->pieces.size()) {
    const std::size_t current = route_piece_;
    const PieceOnPath& piece = route_->pieces[current];
    const double sprayed_m = piece.sprayed_m(progress_m_, reached_m);
    if (sprayed_m > 0.0) {
      aircraft_.stores.spray(vehicle_, sprayed_m);
      sortie_.sprayed += metres(sprayed_m);
      spray_left_m_ -= sprayed_m;
    }
    while (route_piece_ == current && next_cell_m_ <= reached_m) {
      if (!is_licensed()) return;
      pass_cell(t);
    }
    if (route_piece_ == current && is_on_tail() && reached_m >= piece.close_m) end_piece(t);
    if (route_piece_ == current) return;
  }
}

void AgentNode::pass_cell(Instant t) {
  const std::uint32_t cell = order_->next_cell();
  const Piece& strip = route_->pieces[route_piece_].piece;
  if (log_.would_break(cell)) flush_flight_log();
  log_.cell(cell, strip, aircraft_);
  const bool closed = ledger_.spray(cell, t);
  order_->spray();
  strays_ = 0;
  if (closed) next_report_ = t;
  if (++route_cell_ == strip.cells.count && !route_->pieces[route_piece_].has_tail()) {
    end_piece(t);
  }
  expect_next_cell();
}

// Past all cells of a piece, with the valve still open.
bool AgentNode::is_on_tail() const {
  return route_cell_ == route_->pieces[route_piece_].piece.cells.count;
}

void AgentNode::end_piece(Instant t) {
  const FieldPoint exit = route_->pieces[route_piece_].piece.exit;
  route_cell_ = 0;
  ++route_piece_;
  flush_flight_log();
  if (route_piece_ == route_->pieces.size()) {
    phase_ = Phase::fly_back;
    leaving_.reset();
    if (next_way() == nullptr) stop_m_ = before_blockage_m(no_stop);
    sortie_.spray_ended = t;
    sortie_.returned_at = exit;
  }
  expect_next_cell();
}

void AgentNode::expect_next_cell() {
  if (route_piece_ >= route_->pieces.size()) return;
  next_cell_m_ = is_on_tail() ? no_stop : route_->cell_m(route_piece_, route_cell_);
}

// The flow controller opens and closes at the place, not at the tick after it.
void AgentNode::move_valve(bool open, Instant t, double share_of_period) {
  is_valve_open_ = open;
  const double left = 1.0 - share_of_period;
  const Xy now_m = aircraft_.truth_m();
  log_.point(t - duration(seconds(left * control_period_s)),
             now_m + left * (truth_before_m_ - now_m), aircraft_.altitude_m(), open, open_width());
}

Length AgentNode::open_width() const {
  const bool works = is_valve_open_ && route_ && route_piece_ < route_->pieces.size();
  return works ? route_->pieces[route_piece_].piece.width : Length{};
}

// Sprayed is what lies within half a swath of the line: beyond it the mix falls on other strips.
bool AgentNode::is_off_line() const {
  return std::abs(aircraft_.pilot().deviation_now().cross_m) > 0.5 * vehicle_.swath.base();
}

// Nothing counts any more until it has stopped and come back.
void AgentNode::stray(Instant t) {
  if (is_valve_open_) move_valve(false, t);
  note("off_line", "is " + fixed(std::abs(aircraft_.pilot().deviation_now().cross_m), 2) +
                       " m beside its line and closes its valve");
  if (is_on_tail()) return end_piece(t);  // all of its cells are sprayed
  flush_flight_log();
  is_astray_ = true;
  has_strayed_ = true;
  if (phase_ == Phase::hold || leaving_) return;
  phase_ = Phase::hold;
  stop_m_ = aircraft_.pilot().pace().along_m() + aircraft_.pilot().pace().braking_m();
}

// Takes up work at the first cell that is not sprayed, unless that failed too often.
void AgentNode::return_to_line(Instant t) {
  is_astray_ = false;
  if (phase_ == Phase::fly_back) return go_home();
  if (is_recalled()) return leave(CloseReason::recalled, t);
  if (has_strayed_ && ++strays_ > most_strays) {
    is_unfit_ = true;
    return leave(CloseReason::strayed, t);
  }
  forget_way();
  relicense();
}

// Turns for home while energy and mix still suffice for it. The way home is flown at ferry speed
// whatever the wind, as far as an order is taken at all; the slack covers braking and turning.
void AgentNode::watch_stores(Instant t) {
  const bool must_go_home = leaving_ && *leaving_ != CloseReason::superseded &&
                            (*leaving_ != CloseReason::recalled || way_bound_to() == nullptr);
  if (must_go_home) return;
  const double slack_s = way_home_slack_s + (settings_.airspace ? hover_slack_s : 0.0);
  if (!reaches_home(slack_s)) return leave(CloseReason::battery_low, t);
  if (leaving_ || route_piece_ >= route_->pieces.size()) return;

  const double tank_m = aircraft_.stores.spray_left_m(vehicle_) + tank_slack_m;
  const PieceOnPath& piece = route_->pieces[route_piece_];
  const double here_m = aircraft_.pilot().pace().along_m();
  double next_m = aircraft_.pilot().pace().braking_m() + 2.0 * piece.spacing_m + hover_m;
  if (piece.is_bent() && here_m < piece.bends_to_m && here_m + next_m > piece.bends_from_m) {
    next_m += piece.bends_to_m - here_m;  // nobody stops beside the line
  }
  if (tank_m < spray_left_m_ && tank_m < next_m) leave(CloseReason::tank_low, t);
}

// The way home is looked up only where the last one and the way since do not answer.
bool AgentNode::reaches_home(double slack_s) {
  const double brake_s =
      2.0 * aircraft_.pilot().pace().speed_mps() / planned_acceleration_mps2(vehicle_);
  const Xy here = aircraft_.estimate_m();
  const auto suffices = [&](double home_m) {
    const double need_s = straight_way_s(home_m, vehicle_) + brake_s + slack_s;
    return aircraft_.stores.flight_left_s(vehicle_) >= need_s;
  };
  if (way_home_ && way_home_->station == home_.id &&
      suffices(way_home_->length_m + detour_factor() * norm(here - way_home_->from))) {
    return true;
  }
  way_home_ = {home_.id, here,
               ferry_pack_m(field_point(here), home_.position, vehicle_, settings_.ferries)};
  return suffices(way_home_->length_m);
}

// What a metre away from where the way home was looked up may add to it.
double AgentNode::detour_factor() const {
  const planner::Relief* relief = settings_.ferries.relief();
  if (relief == nullptr) return 1.0;
  constexpr double steepest = 1.0;
  return 1.0 / relief->rule().slowest +
         steepest * relief->rule().climb_energy_s_per_m * vehicle_.ferry_speed.base();
}

void AgentNode::leave(CloseReason reason, Instant t) {
  leaving_ = reason;
  const auto& stores = aircraft_.stores;
  if (reason != CloseReason::superseded) {
    note("return_early",
         (reason == CloseReason::tank_low   ? "returns for mix, "
          : reason == CloseReason::strayed  ? "cannot be held on its line and returns, "
          : reason == CloseReason::recalled ? "is called home by the operator, "
                                            : "returns for energy, ") +
             fixed(100.0 * stores.tank_share, 1) + " % of a tank and " +
             fixed(100.0 * stores.pack_share, 1) + " % of a pack left");
  }
  if (phase_ == Phase::hold) return come_to_rest(t);
  stop_m_ = leaving_stop_m();
}

// The centre of the next cell at which it can stop, so that work resumes exactly there, or the end
// of the piece; anywhere where nothing is sprayed. Where the air is shared nobody stops on a way,
// unless its pack makes it.
double AgentNode::leaving_stop_m() const {
  const double soonest_m =
      aircraft_.pilot().pace().along_m() + aircraft_.pilot().pace().braking_m();
  const Way* way = way_bound_to();
  const bool is_to_work = way != nullptr && way->to_piece < route_->pieces.size();
  if (is_to_work && soonest_m <= way->ends_m && leaving_ != CloseReason::battery_low) {
    return std::min(stop_m_, way->ends_m);
  }
  if (route_piece_ >= route_->pieces.size() || leaving_ == CloseReason::superseded) {
    return std::min(stop_m_, soonest_m);
  }
  const PieceOnPath& piece = route_->pieces[route_piece_];
  if (soonest_m <= piece.open_m) return std::min(stop_m_, soonest_m);
  for (std::uint32_t i = route_cell_; i < piece.piece.cells.count; ++i) {
    const bool is_end = i + 1 == piece.piece.cells.count && piece.has_tail();
    const double cell_m = is_end ? piece.close_m : route_->cell_m(route_piece_, i);
    if (cell_m >= soonest_m && !piece.is_beside_its_line(cell_m)) return std::min(stop_m_, cell_m);
  }
  return std::min(stop_m_, piece.close_m);
}

void AgentNode::come_to_rest(Instant t) {
  if (leaving_ == CloseReason::superseded) {
    leaving_.reset();
    is_astray_ = false;
    forget_way();
    if (order_->is_finished()) return fly_home(t);
    phase_ = Phase::hold;
    return is_recalled() ? leave(CloseReason::recalled, t) : relicense();
  }
  if (leaving_) return fly_home(t);
  if (is_astray_) return return_to_line(t);
  if (is_blocked()) return meet_blockage(t);
  if (awaits_way() && may_fly(*next_way())) return;
  if (phase_ == Phase::fly_back) return land(t);
  if (phase_ != Phase::hold && stop_m_ < no_stop) begin_hold(t);
}

void AgentNode::begin_hold(Instant t) {
  phase_ = Phase::hold;
  if (is_valve_open_) move_valve(false, t);
  flush_flight_log();
  const char* why = level_ == FleetLevel::hold ? "holds, as the operator orders, before cell "
                                               : "waits in the air for a grant of cell ";
  note("hold_begun", why + std::to_string(order_->next_cell()));
}

void AgentNode::end_hold() {
  phase_ = progress_m_ >= route_->pieces.front().open_m ? Phase::spray : Phase::fly_out;
  note("hold_ended", "goes on");
}

void AgentNode::fly_home(Instant t) {
  if (is_valve_open_) move_valve(false, t);
  ledger_.close_all(leaving_.value_or(CloseReason::superseded), t);
  next_report_ = t;
  leaving_.reset();
  is_astray_ = false;
  flush_flight_log();
  sortie_.spray_ended = t;
  sortie_.returned_at = field_point(aircraft_.estimate_m());
  go_home();
}

void AgentNode::go_home() {
  follow(lay(aircraft_.estimate_m(), {}, metres(aircraft_.altitude_m())));
  phase_ = Phase::fly_back;
  stop_m_ = next_way() == nullptr ? before_blockage_m(no_stop) : 0.0;
}

void AgentNode::follow(SortieRoute route) {
  if (route_) flown_m_ += aircraft_.pilot().pace().along_m();
  note_outside(route);
  route_ = std::move(route);
  laid_altitude_m_ = aircraft_.altitude_m();
  slot_.drop();
  ways_given_ = route_->ways.front().ends_m < 2.0 * vehicle_.swath.base() ? 1 : 0;
  laid_from_m_ = route_->path.segments().front().from;  // the estimate moves at take-off
  aircraft_.follow(route_->path);
  route_piece_ = 0;
  route_cell_ = 0;
  progress_m_ = 0.0;
  spray_left_m_ = route_->spray_m;
  expect_next_cell();
}

// Where grants let the aircraft go from now on.
void AgentNode::relicense() {
  if (!is_airborne() || phase_ == Phase::fly_back || leaving_ || is_astray_) return;
  if (!may_work() || !is_licensed()) return;
  if (route_->pieces.empty()) {  // hovers without a way: a new order came
    const auto rest = order_->rest_of_sortie();
    home_ = haven();
    follow(lay(aircraft_.estimate_m(), rest, metres(aircraft_.altitude_m())));
  }
  stop_m_ = before_blockage_m(licensed_stop_m());
  if (phase_ == Phase::hold) end_hold();
}

// The last licensed cell before the first that is not.
double AgentNode::licensed_stop_m() const {
  const Way* way = next_way();
  double stop_m = no_stop;  // of what lies before
  for (std::size_t i = route_piece_; i < route_->pieces.size(); ++i) {
    if (way != nullptr && way->to_piece == i) return way->begins_m;
    const PieceOnPath& piece = route_->pieces[i];
    const CellRange cells = piece.piece.cells;
    const std::uint32_t first = cells.first + (i == route_piece_ ? route_cell_ : 0);
    const std::uint32_t licensed = first < end(cells) ? ledger_.licensed_to(first) : first;
    if (licensed < end(cells)) {
      return licensed > first ? route_->cell_m(i, licensed - 1 - cells.first) : stop_m;
    }
    stop_m = piece.has_tail() ? piece.close_m : route_->cell_m(i, cells.count - 1);
  }
  return way == nullptr ? no_stop : way->begins_m;
}

void AgentNode::flush_flight_log() {
  if (!log_.is_empty()) send(log_.take());
}

}  // namespace furrow::agents
