#pragma once
// What waiting at the stations makes of the aircraft's plans.

#include "scheduler/fleet_plan.hpp"
#include "scheduler/flight_times.hpp"

#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

namespace furrow::scheduler {

/// The times of one aircraft's plan that a queue cannot change, in seconds.
struct Itinerary {
  AgentId agent;
  /// One entry per return: the flight that ends with it, and the time in the bay after it.
  std::vector<double> flights_s, services_s;
  std::vector<std::uint32_t> stations;  ///< One per return: index into the fleet's stations.
  double last_spray_s;  ///< From the last leaving of the station to the last sprayed cell.
  double last_home_s;   ///< From there to the station.
  bool flies;           ///< False for an empty share.
  double begins_s = 0;  ///< Mission time of its first take-off.
  bool is_sure = true;  ///< Packs are good for all flights as they are flown.
};

/// The plan as it is flown, all of it from one station.
/// @param times  Of the share that the plan is for, with that station alone.
Itinerary itinerary(AgentId agent, std::uint32_t station, const planner::ReturnPlan& plan,
                    const FlightTimes& times);

/// The plan as it is flown from several.
/// @param landings  By sortie: the station where it ends, as the fleet and `times` count them.
Itinerary itinerary(AgentId agent, std::span<const std::uint32_t> landings,
                    const planner::ReturnPlan& plan, const FlightTimes& times);

/// Swaps packs as flights take them that accelerate, brake and turn, which the problems leave out
/// on level land: of the plan and, as far as bays are held longer, of its itinerary.
/// @param landings  By sortie: the problem of the one share at the station where it ends.
void swap_as_flown(std::span<const planner::ReturnProblem* const> landings,
                   planner::ReturnPlan& plan, Itinerary& itinerary);

/// Of an aircraft without a share.
Itinerary grounded(AgentId agent);

/// How a fleet's mission is expected to go.
struct Forecast {
  std::vector<std::vector<Visit>> visits;     ///< By itinerary, one per return.
  std::vector<double> spray_ends_s, lands_s;  ///< By itinerary; 0 for those that do not fly.
  double makespan_s = 0.0;                    ///< When the last cell is sprayed.
  bool is_sure = true;                        ///< All itineraries are.
  double queue_wait_s = 0.0;                  ///< Sum over all visits.
  double late_s = 0.0;  ///< By which services end after plans have them done, summed.
};

/// Whether an aircraft that lands then is down when plans must have it down.
bool is_in_time(const Vehicle& vehicle, double lands_s);

/// Whether all are, and all services within the hours of their stations.
/// @param fleet  In the order of the forecast's itineraries.
bool is_in_time(std::span<const Vehicle> fleet, const Forecast& forecast);

/// What missions are compared by: the makespan, then the sum of all finishes.
std::tuple<double, double> worth(const Forecast& forecast);
/// @param spray_ends_s  By aircraft.
std::tuple<double, double> worth(std::span<const double> spray_ends_s);

/// Where flights begin one by one.
struct Pads {
  double slot_s = 0.0;                    ///< From one take-off to the next from the same pad.
  std::vector<std::uint32_t> homes{};     ///< By itinerary: the pad of its first take-off.
  std::vector<std::uint32_t> stations{};  ///< By station: the pad there.
};

/// Flies all itineraries, each from its begin. Each station serves first come first served, those
/// who come at the same instant by agent id, in the lowest free bay, from when it opens on; after
/// it closes it goes on, which is told.
///
/// @param pads  Without a slot whoever is ready takes off.
/// Time O(visits * (log itineraries + bays)), with pads the take-offs of one besides.
Forecast forecast(std::span<const Itinerary> itineraries, std::span<const Station> stations,
                  const Pads& pads = {});

/// When each of a fleet is done, changed one by one. Each aircraft keeps to one station, so only
/// the queues that it leaves and joins are flown again.
class FleetEnds {
 public:
  FleetEnds(std::vector<Itinerary> itineraries, std::span<const Station> stations);

  /// By itinerary: mission times of the last sprayed cells; 0 for those that do not fly.
  const std::vector<double>& spray_ends_s() const { return ends_s_; }
  const std::vector<Itinerary>& itineraries() const { return itineraries_; }

  /// The same with `other` in place of itinerary `index`.
  std::vector<double> with(std::size_t index, const Itinerary& other) const;
  void change(std::size_t index, Itinerary other);

 private:
  std::vector<Itinerary> itineraries_;
  std::span<const Station> stations_;
  std::vector<double> ends_s_;
};

/// The same for aircraft that all use one station, without keeping the visits: for the inside of an
/// optimisation, where it is asked for a hundred thousand times.
class QueueClock {
 public:
  QueueClock(const Station& station, std::vector<Itinerary> itineraries);

  /// Total wait at the station when `other` is flown in place of itinerary `index`.
  double queue_wait_s(std::size_t index, Itinerary other);

  /// Total wait of the others when itinerary `index` stays on the ground.
  double queue_wait_without_s(std::size_t index);

 private:
  std::vector<Itinerary> itineraries_;  ///< In order of agent id.
  double opens_s_;
  std::vector<double> free_s_;
};

}  // namespace furrow::scheduler
