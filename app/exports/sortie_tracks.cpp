#include "app/exports/sortie_tracks.hpp"

#include "scheduler/orders.hpp"

namespace furrow::app {
namespace {

constexpr double altitude_m = 3.0;  // above the crop, as plant-protection UAVs fly

// A place is named once; what the valve does from it on is the last word on it.
void add(std::vector<exchange::TrackPoint>& points, FieldPoint at, bool is_spraying,
         Length width = {}) {
  if (!points.empty() && points.back().at == at) {
    points.back() = {at, is_spraying, width};
  } else {
    points.push_back({at, is_spraying, width});
  }
}

// The bends of a ferry way, its ends left out.
void add_bends(std::vector<exchange::TrackPoint>& points, const std::vector<FieldPoint>& way) {
  for (std::size_t i = 1; i + 1 < way.size(); ++i) add(points, way[i], false);
}

std::vector<exchange::TrackPoint> track(const SortieOrder& order, FieldPoint home,
                                        FieldPoint station, const planner::FerryMap& ferries) {
  std::vector<exchange::TrackPoint> points;
  add_bends(points, ferries.way(home, order.pieces.front().entry));
  bool is_first = true;
  for (const Piece& piece : order.pieces) {
    if (!is_first) {
      for (const FieldPoint& way_point : piece.approach) add(points, way_point, false);
    }
    is_first = false;
    add(points, piece.entry, true, piece.width);
    if (!(piece.from == piece.entry)) add(points, piece.from, true, piece.width);
    add(points, piece.to, true, piece.width);
    add(points, piece.exit, false);
  }
  add_bends(points, ferries.way(order.pieces.back().exit, station));
  return points;
}

}  // namespace

std::vector<exchange::SortieTrack> sortie_tracks(const scheduler::FleetPlan& plan,
                                                 std::optional<Length> survey_height) {
  std::vector<exchange::SortieTrack> tracks;
  for (const scheduler::UavPlan& uav : plan.uavs) {
    std::uint32_t number = 0;
    FieldPoint home = uav.vehicle.home;
    for (const SortieOrder& order : scheduler::orders(plan.route, uav)) {
      const FieldPoint landing = scheduler::landing(uav, number).position;
      tracks.push_back({.uav = uav.vehicle.id,
                        .sortie = ++number,
                        .home = home,
                        .landing = landing,
                        .points = track(order, home, landing, plan.route.ferries),
                        .altitude = survey_height.value_or(metres(altitude_m)),
                        .spray_speed = uav.vehicle.spray_speed,
                        .ferry_speed = uav.vehicle.ferry_speed});
      home = landing;  // from the second sortie on
    }
  }
  return tracks;
}

}  // namespace furrow::app
