#pragma once
// The ground under a mission, and how its aircraft keep their height over it.

#include "core/vehicle.hpp"
#include "planner/routes/plan_route.hpp"
#include "planner/routes/scene.hpp"
#include "planner/terrain/flight_cost.hpp"
#include "planner/terrain/terrain.hpp"

#include <optional>
#include <span>
#include <vector>

namespace furrow::planner {

/// How a fleet keeps its height. All > 0 unless said.
struct HeightRule {
  Length spray_height = metres(3);  ///< Above the ground, kept at work: on strips and between them.
  Length clearance = metres(15);    ///< Least height above the ground on the way of a ferry, >= 0.
  std::optional<Length> ceiling{};  ///< No ferry flies higher, above the datum.
  Speed climb = metres_per_second(3), descent = metres_per_second(2);
  /// Pack used for a metre of climb, in seconds of level flight, >= 0.
  double climb_energy_s_per_m = 0.1;
  double slowest = 0.25;     ///< Share of a speed that slopes slow an aircraft down to at most.
  std::uint32_t layers = 1;  ///< Heights that ferries are spread over, by aircraft, >= 1.
  Length layer = metres(5);  ///< Between them.
};

/// The ground of a mission, as a scenario says it.
struct TerrainModel {
  Terrain ground;
  HeightRule rule{};
  std::vector<KeepOut> keep_out{};  ///< No aircraft enters them.
  /// How ferries look for ways past hills; none: theirs are the shortest in plan.
  std::optional<RouteSettings> ferries{};
};

/// A piece of a way with its height: straight from where the piece before ended.
struct AirLeg {
  FieldPoint to;
  double limit_mps;    ///< Speed over the ground at which climb and descent are kept.
  double altitude_m;   ///< At its end, above the datum.
  bool bends = false;  ///< Whether it ends at a way point, where the way may turn.
};

/// Pieces of a way, from `altitude_m` on.
struct AirWay {
  double altitude_m;
  std::vector<AirLeg> legs;
};

/// The ground as aircraft fly over it. A copy shares the samples.
class Relief {
 public:
  Relief(Surface surface, HeightRule rule, std::vector<KeepOut> keep_out);
  Relief(const TerrainModel& model, const Extent& extent);

  const Surface& surface() const { return surface_; }
  const HeightRule& rule() const { return rule_; }
  const std::vector<KeepOut>& keep_out() const { return keep_out_; }

  /// Where an aircraft at work is above `p`, above the datum.
  double work_altitude_m(FieldPoint p) const;

  /// From `from` to `to` at work height: slower than `speed` where the ground rises or falls faster
  /// than an aircraft climbs or descends. Pieces of equal length, of at most `pitch_m`.
  AirWay contour(FieldPoint from, FieldPoint to, Speed speed) const;

  /// A way over `between` at the heights given for it, from work height to work height.
  /// @pre as many heights as places
  std::vector<WayPoint> way_at(FieldPoint from, std::span<const FieldPoint> between,
                               std::span<const double> altitudes_m, FieldPoint to) const;

  /// Straight from place to place at their heights: slower than `speed` where that climbs or
  /// descends faster than an aircraft may.
  /// @param way  From where it starts to where it ends, two or more, none above another.
  AirWay straight(std::span<const WayPoint> way, Speed speed) const;

  /// The lowest ferry along `way`, from work height to work height, that keeps the clearance and
  /// `layer` above it wherever it has climbed out and not yet begun to come down. It climbs and
  /// descends as steeply as `speed` allows, and is never under work height, where ground that is
  /// steeper slows it down.
  /// @param way     In plan, from where it starts to where it ends, two or more.
  /// @param begins  Altitude of an aircraft that is in the air already; below work height it counts
  ///                for work height.
  AirWay ferry(std::span<const FieldPoint> way, Speed speed, Length layer,
               std::optional<Length> begins = {}) const;

  /// That of `vehicle` in its layer.
  AirWay ferry(std::span<const FieldPoint> way, const Vehicle& vehicle,
               std::optional<Length> begins = {}) const {
    return ferry(way, vehicle.ferry_speed, layer_of(vehicle.id), begins);
  }

  /// The highest that any ferry flies.
  double highest_ferry_m() const;

  /// The keep-out volumes that ferries can come into: those that reach below the highest ferry, or
  /// the ceiling, and above the lowest aircraft at work. Indices of `keep_out`.
  std::vector<std::size_t> in_the_way() const;

  /// The ferry height of an aircraft above that of the lowest layer.
  Length layer_of(AgentId agent) const;

  /// Of a way at the speeds of its legs.
  FlightCost cost(FieldPoint from, const AirWay& way) const;

  /// Metres of a way where even the least speed climbs or descends faster than the rule says: the
  /// height is not kept there.
  double too_steep_m(FieldPoint from, const AirWay& way) const;

  double pitch_m() const { return pitch_m_; }

 private:
  double limit_mps(double run_m, double rise_m, double speed_mps) const;
  /// Places along a way and in the middle between each two: 2 n + 1 of both.
  struct Course {
    std::vector<double> x_m, y_m, ground_m;
    std::vector<double> run_m;       ///< From each place to the next.
    std::vector<std::size_t> bends;  ///< Places that are way points, the first left out.
  };
  Course course(std::span<const FieldPoint> way) const;
  std::vector<double> lowest_heights_m(const Course& course, double up, double down) const;

  Surface surface_;
  HeightRule rule_;
  std::vector<KeepOut> keep_out_;
  double pitch_m_;
};

}  // namespace furrow::planner
