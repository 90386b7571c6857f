#pragma once

#include "agents/aircraft.hpp"
#include "agents/conduct/bay_visit.hpp"
#include "agents/conduct/flight_log.hpp"
#include "agents/conduct/flight_slot.hpp"
#include "agents/conduct/order.hpp"
#include "agents/conduct/sortie_route.hpp"
#include "agents/conduct/work_ledger.hpp"
#include "agents/settings.hpp"
#include "agents/vehicle/lookout.hpp"
#include "core/node.hpp"

#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace furrow::agents {

/// One aircraft with its conduct: follows the scheduler's command as far as grants release it,
/// returns for mix and energy, and reports. Models Node.
///
/// It senses, decides and moves on a grid of 0.1 s of mission time. A message acts on the first
/// tick after its arrival, so its flight is a function of what it was told and when, not of the
/// instants at which it is stepped. On the ground it costs a heartbeat a second.
class AgentNode {
 public:
  explicit AgentNode(AgentSettings settings);

  Outbox step(const Inbox& inbox, Instant now);

 private:
  // agent_node.cpp: messages in and out, and when to wake.
  void receive(const Body& body, Instant now);
  void receive_scheduler(const SchedulerState& state, Instant now);
  void send(Body body) { out_.push_back(std::move(body)); }
  void note(std::string kind, std::string detail);
  void acknowledge(AckStatus status, std::string reason = {});
  void send_info(Instant now);
  void send_report(Instant now);
  void heartbeat(Instant now);
  AgentState state() const;
  bool is_retired() const;
  Instant wake_after(Instant now) const;
  Instant next_flight_event(Instant now) const;

  // agent_flight.cpp: in the air.
  bool is_airborne() const;
  void fly_one_period(Instant t);
  void work(Instant t);
  void note_detour(const PieceOnPath& piece, double before_m, double reached_m);
  void pass_cells(double reached_m, Instant t);
  void pass_cell(Instant t);
  bool is_on_tail() const;
  void end_piece(Instant t);
  void expect_next_cell();
  void note_place(Instant t);
  void move_valve(bool open, Instant t, double share_of_period = 1.0);
  Length open_width() const;
  bool is_off_line() const;
  void stray(Instant t);
  void return_to_line(Instant t);
  void watch_stores(Instant t);
  static constexpr double way_home_slack_s = 2.0;
  bool reaches_home(double slack_s);
  double detour_factor() const;
  void keep_height();
  void leave(CloseReason reason, Instant t);
  double leaving_stop_m() const;
  void come_to_rest(Instant t);
  void begin_hold(Instant t);
  void end_hold();
  void fly_home(Instant t);
  void go_home();
  void follow(SortieRoute route);
  void relicense();
  double licensed_stop_m() const;
  void flush_flight_log();

  // agent_obstacles.cpp: what no plan knew.
  void look_out(Instant t);
  void report_obstacles();
  void reroute(Instant t);
  void swerve(SortieRoute route);
  void stop_short(Instant t);
  void note_outside(const SortieRoute& route);
  bool is_blocked() const;
  void meet_blockage(Instant t);
  double before_blockage_m(double stop_m) const;

  // agent_traffic.cpp: the air it shares.
  void receive_grant(const FlightGrant& grant, Instant now);
  void mind_traffic(Instant begins);
  void wait_for_way(Instant begins);
  void claim_way(Instant begins);
  void open_way();
  void ask_for_way(const Way& way, Departure departure, Instant at);
  void announce_way();
  void forget_way();
  bool may_take_off(Instant now);
  void ask_to_take_off(const SortieRoute& route, Instant now);
  const Way* next_way() const;
  const Way* way_given() const;
  const Way* way_bound_to() const;
  CellRange cells_at_end(const Way& way, const SortieRoute& route) const;
  bool awaits_way() const;
  bool may_fly(const Way& way) const;
  bool is_way_due() const;
  double claim_from_m() const;
  const planner::HeightRule& height_rule() const;
  SortieRoute lay(Xy from_m, std::span<const Piece> pieces,
                  std::optional<Length> begins = {}) const;

  // agent_operator.cpp: what the operator lets it do.
  void obey(const OperatorState& state, Instant now);
  void come_home(Instant t);
  void pause();
  void go_on(Instant t);
  void dismiss(Instant t);
  void heed_loss(const SchedulerState& state, Instant now);
  bool may_work() const { return level_ == FleetLevel::fly && !is_taken_out_ && !is_given_up_; }
  bool is_dismissed() const { return level_ == FleetLevel::end || is_taken_out_ || is_given_up_; }
  bool is_recalled() const { return level_ == FleetLevel::land || is_dismissed(); }

  // agent_ground.cpp: orders, stations, take-off.
  struct Demand {
    bool swap;
    double fill;
  };
  void adopt(const Command& command, Instant now);
  void replace_order(const Command& command, Instant now);
  bool is_revision(const Command& command) const;
  bool keeps_course(const Order& next) const;
  void live_until(Instant now);
  void prepare(Instant t);
  Demand demand() const;
  void leave_bay();
  void go_without(Instant t);
  bool go_elsewhere(Instant t);
  void try_divert(Instant now);
  const Station* nearest_open(FieldPoint from) const;
  const Station& haven() const;
  void note_lack(bool swap, double fill);
  bool lacks_mix(const SortieRoute& route) const;
  void give_up(CloseReason reason, std::string why, Instant t);
  void try_take_off(Instant now);
  bool is_licensed() const;
  void take_off(SortieRoute route, Instant t);
  void land(Instant t);
  void leave_fleet(Instant t);
  void fall(Instant t);
  void finish(Instant t);
  void report_sortie();
  const Station& station(StationId id) const;

  AgentSettings settings_;
  Vehicle vehicle_;
  Aircraft aircraft_;
  FlightLog log_;
  Surroundings around_;
  Lookout lookout_;
  std::vector<SeenObstacle> sightings_{};  // its own, that no order named yet
  Phase phase_ = Phase::idle;
  std::vector<Body> out_;

  // Orders and grants.
  std::optional<Order> order_;
  WorkLedger ledger_;
  Epoch scheduler_epoch_{};
  bool is_running_ = false;  // its command has been taken to the air
  AckStatus last_ack_ = AckStatus::received;
  std::string last_ack_reason_;

  // What the operator lets it do.
  FleetLevel level_ = FleetLevel::fly;
  bool is_taken_out_ = false;
  bool is_given_up_ = false;  // the scheduler took it for lost
  Epoch level_epoch_{};
  std::uint32_t level_revision_ = 0;

  // The flight under way.
  Instant last_tick_{};
  Xy truth_before_m_{};  // at the tick before
  Station home_{};
  std::optional<SortieRoute> route_;
  Xy laid_from_m_{};  // where the route begins
  double laid_altitude_m_ = 0.0;
  std::size_t route_piece_ = 0;
  std::uint32_t route_cell_ = 0;  // in the piece
  double next_cell_m_ = 0.0, progress_m_ = 0.0, stop_m_ = 0.0, spray_left_m_ = 0.0;
  double flown_m_ = 0.0;  // on earlier routes of this sortie
  double climb_s_ = 0.0;  // of the pack, by this sortie's climbs
  struct WayHome {
    StationId station;
    Xy from;
    double length_m;  // of level flight
  };
  std::optional<WayHome> way_home_;  // as last looked up
  bool is_valve_open_ = false;
  bool leaves_land_ = false;  // its route, around an obstacle
  bool is_astray_ = false;    // stops with the valve closed, to return to its line
  bool has_strayed_ = false;  // since it left that, not to stop short of an obstacle
  int strays_ = 0;            // since the last cell
  bool is_unfit_ = false;     // could not be held on its line
  std::optional<CloseReason> leaving_;
  SortieReport sortie_{};
  bool has_unreported_sortie_ = false;
  std::uint32_t sorties_flown_ = 0, pack_ = 1;

  // The air it shares.
  FlightSlot slot_;
  std::size_t ways_given_ = 0;  // of the route's
  Duration lead_{200'000'000};  // from a claim to the departure it asks for
  bool diverts_ = false;        // stands ready to fly to another station

  // At stations.
  bool is_prepared_ = true;  // stores suffice for what comes next
  Instant ready_{};          // since when nothing but what came last kept it on the ground
  std::optional<BayVisit> visit_;
  std::uint64_t claims_ = 0;
  std::set<StationId> closed_;  // stations that refused it
  std::string lack_;            // what its station has come to the end of, as words

  // Timers.
  bool is_known_ = false;  // has introduced itself
  bool is_scheduler_lost_ = false, is_mission_over_ = false, is_retired_ = false;
  Instant next_state_{}, next_info_{}, next_report_ = never, scheduler_heard_{};
};

}  // namespace furrow::agents
