#pragma once

#include "core/node.hpp"
#include "planner/avoidance/onboard.hpp"
#include "planner/coverage/plane.hpp"
#include "scheduler/airspace.hpp"
#include "scheduler/blockage.hpp"
#include "scheduler/fleet_plan.hpp"
#include "scheduler/ledger.hpp"
#include "scheduler/takeover.hpp"

#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

namespace furrow::scheduler {

/// Over the field, at work or on the way to it.
constexpr bool is_at_work(Phase phase) {
  return phase == Phase::fly_out || phase == Phase::spray || phase == Phase::hold;
}

constexpr bool is_in_air(Phase phase) { return is_at_work(phase) || phase == Phase::fly_back; }

/// An order that is known before the mission.
struct TimedOrder {
  Instant at;
  OperatorOrder order;
};

struct SchedulerSettings {
  FleetPlan plan;
  Epoch epoch;             ///< Of this incarnation, > 0.
  Duration agent_lease;    ///< An agent silent for longer is lost; > 0.
  Duration mission_limit;  ///< The mission is given up after this mission time; > 0.
  Duration gather_time{std::chrono::seconds{10}};  ///< An agent not heard of by then is lost.
  std::uint32_t windows_ahead = 2;                 ///< Open windows per agent, >= 1.
  std::vector<TimedOrder> orders{};                ///< Of the operator, in order of time.
  Effort effort{};                                 ///< Whenever work changes hands.
  /// That aircraft in the air keep from each other; none: whoever asks may fly.
  std::optional<Length> separation{};
  /// Of the mission, whether the plan goes there or not; those of the plan need not be named.
  std::vector<Station> stations{};
  planner::AvoidanceRule avoidance{};  ///< By which aircraft fly around obstacles.
};

/// The scheduler of a mission as a node.
///
/// It waits until every agent of the plan has been heard of, commands each its whole plan, and
/// releases the work window by window: at most one piece each, ids 1, 2, 3, ... per agent, in the
/// order of the agent's list; so the rest of a window that was closed early comes first. All it
/// sends is a level and is sent again when an agent's heartbeat shows that the agent lacks it, at
/// most every two seconds.
///
/// An agent silent for longer than its lease is lost, and has no work any more in this epoch: it
/// comes home once it hears so. Its open windows are uncertain for good. The rest of its list is
/// shared over the others; then what nobody has begun is shared out anew over all, if that ends the
/// mission earlier. Each whose list changes is sent a new revision: what it has begun, then its
/// other sorties. Strips at which aircraft are lost again and again, and what nobody reaches, are
/// given up.
///
/// An agent that joins late is not waited for. Once it is heard of, the sorties that nobody has
/// begun are shared out anew over all, unless the others would be done as early without it.
///
/// Where a bay or a station fails, closes or comes to the end of its stock, what nobody has begun
/// is planned anew for those that are left, be they in the plan or not. Whoever is to be served
/// before more work is foreseen to wait behind the queue that its station tells.
///
/// An obstacle that an aircraft meets is told to all that still fly or will, by a new revision with
/// the same work. From then on forecasts count the ways around it. Where it blocks a strip, the
/// cells beside it are given up, and the rest of the strip is flown to from behind it, next in the
/// list of the aircraft that met it.
///
/// What the operator orders becomes a level that every agent is told again and again. An agent that
/// is taken out closes its windows on the way home; the rest of its list is shared over the others.
/// Once the operator has stopped the mission, what is not sprayed is given up.
///
/// An aircraft that is available for a time only is commanded once that begins, and taken out as
/// the operator would in time to be home when it ends.
///
/// Where aircraft keep a distance, what they claim to fly between stations and work is put off
/// until it is clear of what others fly and of where they are at work. Work that lies nearer to
/// other work than they keep is granted to one of them at a time, as it comes to it. Where a lost
/// aircraft may still fly the air stays its own: until it is heard of on the ground, or a way home
/// that it was given is flown, or its pack is empty.
///
/// The mission is finished when every cell is sprayed or given up and every living agent is down;
/// completed when none was given up but what is uncertain. Cells that the route leaves out are
/// reported at the start.
class SchedulerNode {
 public:
  explicit SchedulerNode(SchedulerSettings settings);

  Outbox step(const Inbox& inbox, Instant now);

  const Ledger& ledger() const { return ledger_; }

 private:
  /// What the scheduler knows of one agent.
  struct Member {
    AgentId agent;
    Vehicle vehicle;
    Station station;
    std::vector<SortieOrder> sorties;  ///< Its list.
    std::vector<Piece> pieces;         ///< The same without the returns.
    double lands_s;                    ///< Forecast mission time at which its list is done.
    std::uint32_t revision = 1;
    std::optional<BootId> boot{};  ///< Of the incarnation listened to.
    Instant last_heard{};
    Phase phase = Phase::idle;
    TimedPlace place{};     ///< As last heard.
    bool accepted = false;  ///< The revision.
    double battery = 1.0;   ///< Share of a pack, as last heard.
    bool lost = false;
    std::vector<Piece> adrift{};  ///< Lost: what it may still fly over.
    Instant down_by{};            ///< Lost: surely on the ground from then on.
    bool joins = false;           ///< Comes late, and has no share of the work yet.
    bool is_out = false;          ///< Taken out, by the operator or as its window ends.
    std::optional<Instant> commanded_at{}, granted_at{};
    Instant asks_again{};     ///< Earliest, for cells that could not be granted.
    bool owes_grant = false;  ///< The level has changed since it was last sent.
  };

  Member* member(AgentId agent, BootId boot, Instant now);
  Member* lost_member(AgentId agent, BootId boot);
  void hear(const Envelope& envelope, Instant now, Outbox& out);
  void hear(const AgentInfo& info, Instant now, Outbox& out);
  void hear(const AgentState& state, Instant now, Outbox& out);
  void hear(const CommandAck& ack, Instant now, Outbox& out);
  void hear(const WorkReport& report, Instant now, Outbox& out);
  void hear(const ObstacleSeen& seen, Instant now, Outbox& out);
  void hear(const StationState& state, Outbox& out);
  void hear(const OperatorOrder& order, Outbox& out);

  // air_traffic.cpp
  void hear(const FlightClaim& claim, Instant now, Outbox& out);
  std::vector<WorkSite> work_sites(const Member& claimant, const FlightClaim& claim,
                                   Instant now) const;
  /// Work up to the next way, and from where and when on.
  struct AtWork {
    TimedPlace from;
    std::vector<Piece> ahead;
  };
  std::optional<AtWork> at_work(const Member& m, Instant now) const;
  void add_sites(const Member& m, Instant now, std::vector<WorkSite>& sites) const;
  void add_work_after(const Member& m, const TimedPlace& arrives, CellRange leads_to,
                      std::vector<WorkSite>& sites) const;
  void add_work(const Member& m, TimedPlace from, const std::vector<Piece>& pieces,
                std::vector<WorkSite>& sites) const;
  void add_site(AgentId agent, TimedPlace& from, FieldPoint to, Speed speed,
                std::vector<WorkSite>& sites) const;
  std::vector<Piece> work_ahead(const Member& m) const;
  std::vector<Piece> work_from(const Member& m, std::uint32_t cell) const;
  std::vector<Piece> up_to_way(const SortieOrder& sortie, std::size_t first) const;
  std::optional<std::uint32_t> first_left(const Piece& piece) const;
  double work_altitude_m(FieldPoint at) const;

  // adrift.cpp: the lost that may still fly.
  void leave_adrift(Member& m, Instant now);
  void hear_adrift(const AgentState& state, Instant now);
  void expect_home(Member& m, Instant now);
  std::optional<AtWork> at_work_adrift(const Member& m, Instant now) const;
  void add_adrift(const Member& m, Instant now, std::vector<WorkSite>& sites) const;

  // near_work.cpp
  struct Line {
    planner::PointM from, to;
  };
  void find_near_work();
  bool is_shared(CellRange cells) const;
  Line line(CellRange cells) const;
  bool may_begin(const Member& m, const SortieOrder& sortie, std::size_t piece, CellRange cells,
                 Instant now) const;
  Length kept_from_near_work(const Member& m, CellRange leads_to) const;
  bool comes_soon_to_next(const Member& m) const;
  bool is_clear(const Member& m, Piece next, CellRange cells, Instant now) const;

  // operator_orders.cpp
  void take_orders(Instant now, Outbox& out);
  std::string take(const OperatorOrder& order, Outbox& out);
  std::string refusal(const OperatorOrder& order) const;
  void set_level(FleetLevel level, std::string_view kind, std::string_view what, Outbox& out);
  void keep_time(Instant now);
  void take_out(AgentId agent, std::string_view why, Outbox& out);
  void hand_over();
  void wind_up(Outbox& out);
  void report_orders(Outbox& out);
  void close_windows(Instant now, Outbox& out);
  Instant called_home(const Member& m) const;
  bool leaves_on_order(const Member& m) const { return m.is_out || level_ == FleetLevel::end; }

  void gather(Instant now, Outbox& out);
  void check_leases(Instant now, Outbox& out);
  void check_limit(Instant now, Outbox& out);
  void direct(Member& m, Instant now, Outbox& out);
  void command(Member& m, Instant now, Outbox& out);
  void release(Member& m, Instant now);
  void send_grant(Member& m, Instant now, Outbox& out);
  void lose(Member& m, std::string_view why, Instant now, Outbox& out);
  void forsake(const Member& m, std::string_view why, Outbox& out);
  void abandon(CellRange cells, std::string_view why, Outbox& out);
  void share_out(Instant now, Outbox& out);
  void welcome(Instant now, Outbox& out);
  void share_anew(Instant now, Outbox& out, bool whatever_it_takes = false);
  void plan_for_failed_supply(Instant now, Outbox& out);
  void foresee_detours(Instant now);
  double detours_left_m(const Member& m) const;
  std::vector<CellRange> take_back(Member& m, Instant now);
  void revise(Member& m);
  bool can_take_more(const Member& m, Instant now) const;
  std::uint32_t cells_left(const Member& m) const;
  double done_s(const Member& m, Instant now) const;
  double bay_free_s(const Station& at, double arrives_s) const;
  void spare_the_fleet(Outbox& out);
  void extend(Member& m, Addition added, Outbox& out);
  void cut_blocked(Member& m, std::uint32_t first, Outbox& out);
  Survivor survivor(const Member& m, Instant now) const;
  const Station& station(StationId id) const;
  const Station& haven(const Station& wanted, double comes_s) const;
  std::vector<Station> open_stations() const;
  void close_stations(Instant now, Outbox& out);
  bool needs(const Member& m, StationId at) const;
  std::vector<CellRange> open_cells(const Member& m) const;
  void finish_if_done(Outbox& out);
  void report_state(Instant now, Outbox& out);
  SchedulerState state() const;
  bool has_work_left(const Member& m) const;
  bool is_down(const Member& m) const;
  bool is_leased(const Member& m) const;
  Instant next_wake(Instant now) const;

  SchedulerSettings settings_;
  Ledger ledger_;
  std::optional<Airspace> airspace_{};
  double near_m_ = 0.0;                       ///< Nearer to each other, work is for one at a time.
  Length swath_{};                            ///< The narrowest of the fleet.
  std::vector<bool> is_near_others_{};        ///< By strip; empty where nobody keeps a distance.
  std::vector<Member> members_;               ///< In order of agent id.
  std::vector<Station> stations_{};           ///< Where sorties can end, bays as they are left.
  std::map<StationId, Instant> next_free_{};  ///< Of these, as last said.
  std::set<StationId> shut_{};                ///< Of these, without a bay or with an empty stock.
  bool has_supply_failed_ = false;            ///< And that is not planned for yet.
  std::vector<CellRange> orphans_{};          ///< Open cells of lost agents, not yet shared out.
  std::vector<KeptObstacle> obstacles_{};     ///< Met in flight, in the order heard of.
  planner::Room room_;                        ///< With these.
  std::vector<std::uint32_t> losses_;         ///< By strip: agents lost at work on it.
  FleetLevel level_ = FleetLevel::fly;
  std::optional<Instant> held_since_{};  ///< Nobody works; forecasts count up to here.
  std::uint32_t level_revision_ = 0, reported_revision_ = 0;
  std::size_t orders_taken_ = 0;  ///< Of the settings' orders.
  std::uint64_t answered_order_ = 0, reported_order_ = 0;
  std::string refusal_{};  ///< Of that order.
  MissionPhase phase_ = MissionPhase::gathering;
  std::optional<MissionPhase> reported_phase_{};
  Instant state_due_{};
  int farewells_ = 5;  ///< How often the end is still told, since messages get lost.
};

}  // namespace furrow::scheduler
