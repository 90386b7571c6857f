#include "scheduler/steep_ways.hpp"

#include "scheduler/orders.hpp"

namespace furrow::scheduler {
namespace {

using planner::AirWay;
using planner::Relief;

FieldPoint first_place(const Relief& relief, FieldPoint from, const AirWay& way) {
  double altitude_m = way.altitude_m;
  for (const planner::AirLeg& leg : way.legs) {
    if (relief.too_steep_m(from, {altitude_m, {leg}}) > 0) return from;
    altitude_m = leg.altitude_m;
    from = leg.to;
  }
  return from;
}

// The flights of one aircraft, followed from place to place.
class Flights {
 public:
  Flights(const planner::FerryMap& ferries, const Vehicle& vehicle, SteepWays& into)
      : ferries_{ferries},
        relief_{*ferries.relief()},
        vehicle_{vehicle},
        into_{into},
        at_{vehicle.home} {}

  void ferry(FieldPoint to) {
    add(into_.between, relief_.ferry(ferries_.ferry_way(at_, to, vehicle_), vehicle_), to);
  }

  void approach(const Piece& piece) {
    std::vector<FieldPoint> way{at_};
    way.insert(way.end(), piece.approach.begin(), piece.approach.end());
    way.push_back(piece.entry);
    if (!piece.approach_altitudes_m.empty()) {
      const auto places =
          relief_.way_at(at_, piece.approach, piece.approach_altitudes_m, piece.entry);
      add(into_.between, relief_.straight(places, vehicle_.ferry_speed), piece.entry);
    } else if (planner::is_high(way)) {
      add(into_.between, relief_.ferry(way, vehicle_), piece.entry);
    } else {
      for (const FieldPoint to : way) follow(into_.between, to, vehicle_.ferry_speed);
    }
  }

  void work(const Piece& piece) {
    follow(into_.rows, piece.from, vehicle_.spray_speed);
    follow(into_.rows, piece.to, vehicle_.spray_speed);
    follow(into_.between, piece.exit, vehicle_.spray_speed);
  }

 private:
  void follow(Steep& sum, FieldPoint to, Speed speed) {
    if (!(to == at_)) add(sum, relief_.contour(at_, to, speed), to);
  }

  void add(Steep& sum, const AirWay& way, FieldPoint to) {
    const double steep_m = relief_.too_steep_m(at_, way);
    if (steep_m > 0 && !sum.first) sum.first = first_place(relief_, at_, way);
    sum.length_m += steep_m;
    at_ = to;
  }

  const planner::FerryMap& ferries_;
  const Relief& relief_;
  const Vehicle& vehicle_;
  SteepWays& into_;
  FieldPoint at_;
};

}  // namespace

SteepWays steep_ways(const FleetPlan& plan) {
  SteepWays all;
  if (plan.route.ferries.relief() == nullptr) return all;
  for (const UavPlan& uav : plan.uavs) {
    Flights flights{plan.route.ferries, uav.vehicle, all};
    std::size_t number = 0;
    for (const SortieOrder& sortie : orders(plan.route, uav)) {
      flights.ferry(sortie.pieces.front().entry);
      for (const Piece& piece : sortie.pieces) {
        if (&piece != &sortie.pieces.front()) flights.approach(piece);
        flights.work(piece);
      }
      flights.ferry(landing(uav, number++).position);
    }
  }
  return all;
}

}  // namespace furrow::scheduler
