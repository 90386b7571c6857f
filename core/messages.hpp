#pragma once
// What the nodes of a fleet tell each other. `idl/` lays the same out on the wire; `transport/`
// translates at its door.

#include "core/ids.hpp"
#include "core/time.hpp"
#include "core/vehicle.hpp"
#include "core/work.hpp"

#include <array>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace furrow {

/// What an aircraft is doing. The value travels on the wire.
enum class Phase : std::uint8_t {
  idle = 0,      ///< On the ground, no order yet.
  fly_out = 1,   ///< From the station to the resume point.
  spray = 2,     ///< On the route; also turning and connecting within a sortie.
  hold = 3,      ///< Hovering on the route, valve closed, for want of a grant.
  fly_back = 4,  ///< From the return point to the station.
  wait = 5,      ///< At the station, queueing for a bay.
  service = 6,   ///< In a bay.
  done = 7,      ///< On the ground, all of its order sprayed.
  offline = 8,   ///< Leaving the fleet on purpose.
};

/// Who an agent is and what it can do. Sent once, and again to a scheduler that asks by a new
/// epoch.
struct AgentInfo {
  AgentId agent;
  BootId boot;
  Vehicle vehicle;
};

/// The heartbeat of an agent, once a second of mission time: its lease is renewed by it.
struct AgentState {
  AgentId agent;
  BootId boot;
  Epoch epoch;             ///< Of the order it follows, 0 without one.
  std::uint32_t revision;  ///< Of the order it follows, 0 without one.
  Phase phase;
  FieldPoint position;  ///< The fix, not the truth.
  double heading_rad;   ///< Clockwise from north.
  Speed ground_speed;
  double tank;                ///< Share of a full tank left.
  double battery;             ///< Share of a full pack left.
  std::uint32_t sortie;       ///< Index into the order's sorties.
  std::uint64_t last_grant;   ///< Highest grant id accepted, 0 before the first.
  std::uint64_t last_closed;  ///< Highest grant id closed, 0 before the first.
};

/// The whole desired plan of one agent, not a change to it: a newer revision replaces an older.
struct Command {
  AgentId agent;
  BootId target_boot;  ///< The incarnation it is meant for.
  Epoch epoch;
  std::uint32_t revision;
  std::vector<SortieOrder> sorties;
  std::vector<SeenObstacle>
      obstacles{};  ///< Met since the plan was made, by anyone: to fly around.
};

enum class AckStatus : std::uint8_t {
  received = 1,
  accepted = 2,
  rejected = 3,
  running = 4,
  done = 5,
  failed = 6,
  cancelled = 7
};

struct CommandAck {
  AgentId agent;
  BootId boot;
  Epoch epoch;
  std::uint32_t revision;
  AckStatus status;
  std::string reason;  ///< Empty unless rejected, failed or cancelled.
};

/// A window of work released to one agent: the only licence to open the valve.
struct GrantWindow {
  std::uint64_t id;  ///< 1, 2, 3, ... per agent and epoch, never reused.
  CellRange cells;   ///< Within one piece of the commanded plan.
  friend constexpr bool operator==(GrantWindow, GrantWindow) = default;
};

/// Every window that is open for an agent, oldest first. A level, not an edge: losing, repeating or
/// reordering it does no harm. Windows at or below the agent's last accepted id are ignored by it.
struct WorkGrant {
  AgentId agent;
  BootId target_boot;
  Epoch epoch;
  std::uint32_t revision;        ///< Of the command whose pieces the windows belong to.
  std::uint64_t closed_through;  ///< Closures up to this id are on the scheduler's books.
  std::vector<GrantWindow> windows;
};

enum class CloseReason : std::uint8_t {
  sprayed = 1,      ///< Every cell of the window.
  tank_low = 2,     ///< The tank would not carry the rest.
  battery_low = 3,  ///< The pack would not carry the rest and the way home.
  superseded = 4,   ///< A newer revision or epoch took over.
  strayed = 5,      ///< It could not be held on its line.
  blocked = 6,      ///< An obstacle stands there, with no room for a detour.
  recalled = 7,     ///< The operator called the aircraft home.
};

/// What became of a granted window. The evidence on which the ledger rests.
struct Closure {
  std::uint64_t grant;
  CellRange cells;        ///< The window as granted.
  std::uint32_t sprayed;  ///< How many of its cells, from the first on, 0 .. cells.count.
  CloseReason reason;
  Instant at;
};

/// Every closure that the scheduler has not yet booked, oldest first. A level, as WorkGrant.
struct WorkReport {
  AgentId agent;
  BootId boot;
  Epoch epoch;
  std::vector<Closure> closures;
};

enum class ClaimStatus : std::uint8_t {
  waiting = 1,   ///< Wants a bay.
  in_bay = 2,    ///< Holds `token`, being served.
  released = 3,  ///< Has left; the bay is free.
};

/// A leased heartbeat for as long as an agent wants or holds a bay.
struct ServiceClaim {
  AgentId agent;
  BootId boot;
  StationId station;
  std::uint64_t claim;    ///< 1, 2, 3, ... per agent: one for each visit.
  Instant first_claimed;  ///< Place in the queue: first come first served, then by agent id.
  ClaimStatus status;
  std::uint64_t token;  ///< The fencing token held, 0 while waiting.
  bool swap;            ///< Wants a charged pack.
  double fill;          ///< Share of a tank wanted, 0 .. 1.
};

/// A bay for a claim. Valid until `expires` unless the claim is renewed before. Without a bay,
/// token or gift it says that the station has nothing left of what is claimed, and never will have.
struct ServiceGrant {
  AgentId agent;
  StationId station;
  std::uint64_t claim;
  std::uint32_t bay;    ///< 1 .. bays; 0: refused.
  std::uint64_t token;  ///< Rises with every grant of the station; an older one is void.
  Instant starts;       ///< Service begins.
  Instant ready;        ///< Service ends: the aircraft is charged and filled as given.
  Instant expires;
  bool swap = true;   ///< A pack is given if it was claimed.
  double fill = 1.0;  ///< Most that is given of the share of a tank claimed.
};

struct BayState {
  std::uint32_t bay;  ///< 1 .. bays.
  bool occupied;
  AgentId agent;  ///< Meaningless unless occupied, as the next two.
  std::uint64_t token;
  Instant ready;
};

struct StationState {
  StationId station;
  std::vector<BayState> bays;
  std::vector<AgentId> queue;  ///< In order of service.
  std::uint32_t swaps;         ///< Charged packs handed out so far.
  Volume filled;               ///< Mix handed out so far.
  std::uint32_t open_bays;     ///< Those that are not shut for good.
  /// When one who comes now is expected to have a bay, behind all who wait; 0 without open bays.
  Instant next_free{};
};

enum class MissionPhase : std::uint8_t { gathering = 1, flying = 2, finished = 3 };

/// The heartbeat of the scheduler.
struct SchedulerState {
  Epoch epoch;
  MissionPhase phase;
  bool completed;                 ///< Finished with every cell sprayed or uncertain.
  std::uint32_t sprayed_cells;    ///< Booked in the ledger.
  std::uint32_t open_cells;       ///< Neither sprayed nor given up.
  std::uint32_t abandoned_cells;  ///< Given up or uncertain, each with an event that says why.
  std::vector<AgentId> lost;
};

/// What the operator lets the fleet do. The value travels on the wire.
enum class FleetLevel : std::uint8_t {
  fly = 0,   ///< Work as planned.
  hold = 1,  ///< Paused: who is at work hovers, valve closed; nobody takes off.
  land = 2,  ///< All at stations, their work kept for when the level is `fly` again.
  end = 3,   ///< All at stations for good, and the mission is over.
};

/// Its word in logs and results.
std::string_view name(FleetLevel level);

/// What the operator can ask for.
enum class OperatorAsk : std::uint8_t {
  pause = 1,       ///< The level `hold`.
  resume = 2,      ///< The level `fly`.
  return_all = 3,  ///< The level `land`.
  stop = 4,        ///< The level `end`, which is final.
  take_out = 5,    ///< One aircraft goes home for good, the others are given its work.
};

/// Its word in scenarios and logs.
std::string_view name(OperatorAsk ask);

/// Sent again until it is answered.
struct OperatorOrder {
  OperatorAsk ask;
  AgentId agent{};           ///< To be taken out; meaningless otherwise.
  std::uint64_t number = 0;  ///< 1, 2, 3, ... per run; 0 for one that nobody waits for.
};

/// What the operator wants, as far as the scheduler has heard it. A level: sent when it changes and
/// with every heartbeat of the scheduler from then on, so it reaches whoever was out of hearing or
/// comes late.
struct OperatorState {
  Epoch epoch;
  std::uint32_t revision;  ///< 1, 2, 3, ... per epoch; a lower one is out of date.
  FleetLevel level;
  std::vector<AgentId> taken_out;  ///< To go home for good; ids rising.
  std::uint64_t answered = 0;      ///< Number of the last order heard, 0 before the first.
  std::string refusal{};           ///< Why that order is not obeyed; empty when it is.
};

/// Something worth a line in the log.
struct Event {
  std::string kind;    ///< snake_case, stable: "agent_lost", "sortie_begun", ...
  std::string detail;  ///< For people: who, what, with numbers and units.
};

/// How the sortie just ended went. Sent when the next begins, or at the end of the last; of that
/// once more if more work came and it was served after all.
struct SortieReport {
  AgentId agent;
  std::uint32_t sortie;  ///< 0, 1, 2, ... in the order flown.
  FieldPoint resumed_at, returned_at;
  Length sprayed, ferried;
  Seconds flight;       ///< Airborne time.
  std::uint32_t pack;   ///< 1, 2, ...: which battery pack flew it.
  double battery_used;  ///< Share of the pack that this sortie took.
  Instant began, spray_ended, landed;
  bool serviced;  ///< The rest is meaningless unless it was served afterwards.
  StationId station;
  std::uint32_t bay;
  bool swapped;
  double filled;  ///< Share of a tank.
  Seconds wait, swap_time, fill_time;
};

/// One point of a true track.
struct TrackPoint {
  Instant at;
  FieldPoint position;
  bool spraying;
  double altitude_m = 0.0;  ///< Above the datum; 0 over level land.
  Length width{};           ///< As of the piece that is sprayed.
};

/// What a simulated aircraft alone can tell: where it truly was. No node acts on it; recorders do.
struct FlightRecord {
  AgentId agent;
  CellRange cells;  ///< Those passed with the valve open since the last record; may be empty.
  /// Signed true cross-track offset at each of these cells' centres, right of the flown direction
  /// positive, one per cell.
  std::vector<float> offsets_m;
  /// Samples on strips since the last record, one per control period: count, sum of squares [m2]
  /// and largest magnitude [m] of the true cross-track error; and the same of what the fix showed.
  struct Deviation {
    std::uint32_t samples;
    double sum_squares;
    double largest;
  };
  Deviation truth, fix;
  std::vector<TrackPoint> track;  ///< Once a second, at bends, and where the valve moves.
};

/// An obstacle that its order does not know, as an aircraft sees it. Said again with the heartbeat
/// until a command names the obstacle.
struct ObstacleSeen {
  AgentId agent;
  BootId boot;
  Epoch epoch;             ///< Of the order it follows.
  std::uint32_t revision;  ///< Of the order it follows.
  SeenObstacle obstacle;
  Length clearance;  ///< That the aircraft keeps from its edge.
};

/// A place in the air at a time.
struct TimedPlace {
  Instant at;
  FieldPoint position;
  double altitude_m;  ///< Above the datum; over level land above the height of work.
  friend constexpr bool operator==(const TimedPlace&, const TimedPlace&) = default;
};

/// What a claimed flight begins with. The value travels on the wire.
enum class Departure : std::uint8_t {
  from_ground = 1,  ///< Can be put off.
  from_hover = 2,   ///< Can be put off, at the price of hovering.
  in_motion = 3,    ///< As claimed or not at all.
  begun = 4,        ///< Flown whatever the answer.
};

/// A way between a station and work that an aircraft wants to fly, or from one place of work to
/// another, as it will fly it. Said again with the heartbeat until it is answered.
struct FlightClaim {
  AgentId agent;
  BootId boot;
  std::uint64_t claim;  ///< 1, 2, 3, ... per agent.
  Departure departure;
  /// Of the piece that it leads to; none: it leads to a station.
  CellRange leads_to{};
  /// Straight and even from place to place, times rising, at least two places. The first is where
  /// it begins if it is not put off.
  std::vector<TimedPlace> track;
};

/// The answer: the way is clear of all others if it begins then. A level, as WorkGrant.
struct FlightGrant {
  AgentId agent;
  BootId target_boot;
  std::uint64_t claim;
  bool is_clear;    ///< Only a flight in motion is ever refused.
  Instant departs;  ///< Not before the claim's first place; meaningless unless clear.
};

using Body =
    std::variant<AgentInfo, AgentState, Command, CommandAck, WorkGrant, WorkReport, ServiceClaim,
                 ServiceGrant, StationState, SchedulerState, Event, SortieReport, FlightRecord,
                 ObstacleSeen, OperatorState, OperatorOrder, FlightClaim, FlightGrant>;

/// The last part of the topic's name, by the body's index.
inline constexpr std::array<std::string_view, std::variant_size_v<Body>> topics{
    "agent_info",     "agent_state",   "command",       "command_ack",   "work_grant",
    "work_report",    "service_claim", "service_grant", "station_state", "scheduler_state",
    "event",          "sortie_report", "flight_record", "obstacle_seen", "operator_state",
    "operator_order", "flight_claim",  "flight_grant"};

constexpr std::string_view topic(const Body& body) { return topics[body.index()]; }

/// A message on its way.
struct Envelope {
  NodeId from;
  std::uint64_t seq;  ///< 1, 2, 3, ... per sender over all topics.
  Instant sent;
  Body body;
};

/// Whether `to` acts on what `envelope` says. Recorders take everything besides.
bool is_recipient(NodeId to, const Envelope& envelope);

/// Whether this is the scheduler's word that the mission is over.
bool ends_mission(const Envelope& envelope);

}  // namespace furrow
