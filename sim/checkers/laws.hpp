#pragma once
// The laws that every run keeps, simulated or real, judged from what was said in it alone.
//
// Work     L1  each cell is sprayed at most once
//          L2  at the end each cell is sprayed or reported, none is silent; of what is closed by
//              aircraft that were taken for lost and fly on nobody knows
//          L5  dose within tolerance, nothing sprayed outside the field, in a hole or on an
//              obstacle, valve closed in every phase but spray
//          L6  work only on a grant newer than the last
// Energy   L7  no one takes off or goes on with less than the way home against the mean wind and
//              the reserve
//          L8  never below the reserve in flight, tank never below zero, liquid adds up
// Stations L9  never two aircraft in one bay
//          L10 a bay is not held by the dead for longer than its lease and a grace
//          L11 first come first served
//          L12 each refill counted once, stock never negative
// Clear    L22 flown tracks keep nine tenths of the safety distance from every obstacle, as soon as
//              it is there, less the bias of the aircraft's fixes and four times what their
//              standard deviation is above that of an RTK; what comes up nearer than an aircraft
//              can stop is excused until it is clear of it
//          L23 over terrain, flown tracks are never more than 1 m below work height; and on ways
//              from and to stations never more than 1 m below the clearance and the aircraft's
//              layer above it, but near their ends, where they climb out and come down, nor above
//              the ceiling; on a survey never more than 1 m below the clearance, or the survey's
//              height where that is less
//          L25 over terrain, no flown track enters a keep-out volume by more than the bias of the
//              aircraft's fixes
// Windows  L27 no bay is given before its station opens, or for longer than it is open
//          L26 no aircraft is in the air outside the time that it is available for
// Apart    L24 two aircraft in the air are never nearer to each other than the separation
// Senders  L21 nobody unknown is spoken of: the other laws go on without what such messages say
// Log      L17 every sender's log is complete and in order, so equal runs have equal digests

#include "core/field.hpp"
#include "core/messages.hpp"
#include "core/station.hpp"
#include "core/surprise.hpp"
#include "core/weather.hpp"
#include "scheduler/fleet_plan.hpp"
#include "sim/checkers/violation.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace furrow::sim {

/// What a run was meant to be.
struct Facts {
  Field field;
  std::vector<Station> stations;
  scheduler::FleetPlan plan;
  Duration claim_lease;  ///< A claim not renewed for this long is void.
  bool whole;            ///< The log ends because the mission did, so L2 must hold.
  Wind wind{};
  std::vector<Surprise> surprises{};
  std::optional<Length> separation{};  ///< None: L24 is not judged.
};

/// Whether an aircraft is off the ground in that phase.
constexpr bool is_airborne(Phase phase) {
  return phase == Phase::fly_out || phase == Phase::spray || phase == Phase::hold ||
         phase == Phase::fly_back;
}

/// One group of laws. `observe` takes every envelope in the log's order.
class Checker {
 public:
  virtual ~Checker() = default;
  virtual void observe(const Envelope& envelope) = 0;
  /// Called once, after the last envelope.
  virtual void conclude(Instant ended) = 0;

  const std::vector<Violation>& violations() const { return violations_; }

 protected:
  void report(std::string law, Instant at, std::string detail) {
    violations_.push_back({std::move(law), at, std::move(detail)});
  }

 private:
  std::vector<Violation> violations_;
};

std::unique_ptr<Checker> work_laws(const Facts& facts);
std::unique_ptr<Checker> energy_laws(const Facts& facts);
std::unique_ptr<Checker> station_laws(const Facts& facts);
std::unique_ptr<Checker> log_laws(const Facts& facts);
std::unique_ptr<Checker> sender_laws(const Facts& facts);
std::unique_ptr<Checker> clearance_laws(const Facts& facts);
std::unique_ptr<Checker> height_laws(const Facts& facts);
std::unique_ptr<Checker> separation_laws(const Facts& facts);
std::unique_ptr<Checker> window_laws(const Facts& facts);

/// Every violation in a log, by time.
std::vector<Violation> violations(const Facts& facts, const std::vector<Envelope>& log,
                                  Instant ended);

}  // namespace furrow::sim
