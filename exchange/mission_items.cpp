#include "exchange/mission_items.hpp"

#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace furrow::exchange {

namespace {

using nlohmann::json;

MissionItem at_place(int command, GeoPoint place, Length altitude) {
  return {mavlink::frame_relative_altitude,
          command,
          {0, 0, 0, 0, place.lat_deg, place.lon_deg, std::round(1000 * altitude.base()) / 1000}};
}

MissionItem speed_item(Speed speed) {
  constexpr double ground_speed = 1, throttle_unchanged = -1;
  return {mavlink::frame_mission,
          mavlink::change_speed,
          {ground_speed, speed.base(), throttle_unchanged, 0, 0, 0, 0}};
}

MissionItem sprayer_item(bool is_on) {
  return {mavlink::frame_mission, mavlink::sprayer, {is_on ? 1.0 : 0.0, 0, 0, 0, 0, 0, 0}};
}

json simple_item(const MissionItem& item, std::size_t id) {
  json plan_item{{"type", "SimpleItem"}, {"autoContinue", true}, {"command", item.command},
                 {"doJumpId", id},       {"frame", item.frame},  {"params", item.params}};
  if (item.frame == mavlink::frame_relative_altitude) {
    constexpr int relative_to_home = 1;
    plan_item["AMSLAltAboveTerrain"] = nullptr;
    plan_item["Altitude"] = item.params[6];
    plan_item["AltitudeMode"] = relative_to_home;
  }
  return plan_item;
}

// seq, current, frame, command, seven parameters, autocontinue; tabs between.
std::string waypoint_line(std::size_t number, const MissionItem& item) {
  std::string line =
      fmt::format("{}\t{}\t{}\t{}", number, number == 0 ? 1 : 0, item.frame, item.command);
  for (const double param : item.params) line += fmt::format("\t{:.9f}", param);
  return line + "\t1\n";
}

}  // namespace

std::vector<MissionItem> mission_items(const SortieTrack& track, const LocalFrame& frame) {
  std::vector<MissionItem> items{
      at_place(mavlink::take_off, frame.to_wgs84(track.home), track.take_off),
      speed_item(track.ferry_speed)};
  bool is_open = false;
  for (std::size_t i = 0; i < track.points.size(); ++i) {
    const TrackPoint& point = track.points[i];
    items.push_back(at_place(mavlink::waypoint, frame.to_wgs84(point.at), point.altitude));
    const bool opens = point.is_spraying && i + 1 < track.points.size();
    if (opens == is_open) continue;
    items.push_back(sprayer_item(opens));
    items.push_back(speed_item(opens ? track.spray_speed : track.ferry_speed));
    is_open = opens;
  }
  items.push_back(at_place(mavlink::land, frame.to_wgs84(track.landing), track.landing_ground));
  return items;
}

std::string qgc_plan(const SortieTrack& track, const LocalFrame& frame) {
  constexpr int ardupilot = 3, quadrotor = 2;
  json items = json::array();
  for (const MissionItem& item : mission_items(track, frame)) {
    items.push_back(simple_item(item, items.size() + 1));
  }
  const GeoPoint home = frame.to_wgs84(track.home);
  const json mission{{"version", 2},
                     {"firmwareType", ardupilot},
                     {"vehicleType", quadrotor},
                     {"globalPlanAltitudeMode", 1},
                     {"cruiseSpeed", track.ferry_speed.base()},
                     {"hoverSpeed", track.ferry_speed.base()},
                     {"plannedHomePosition", {home.lat_deg, home.lon_deg, 0}},
                     {"items", std::move(items)}};
  const json fence{{"version", 2}, {"circles", json::array()}, {"polygons", json::array()}};
  const json plan{{"fileType", "Plan"},
                  {"version", 1},
                  {"groundStation", "QGroundControl"},
                  {"geoFence", fence},
                  {"rallyPoints", {{"version", 2}, {"points", json::array()}}},
                  {"mission", mission}};
  return plan.dump(2) + "\n";
}

std::string waypoints(const SortieTrack& track, const LocalFrame& frame) {
  MissionItem home = at_place(mavlink::waypoint, frame.to_wgs84(track.home), metres(0));
  home.frame = mavlink::frame_global;
  std::string file = "QGC WPL 110\n" + waypoint_line(0, home);
  std::size_t number = 1;
  for (const MissionItem& item : mission_items(track, frame)) file += waypoint_line(number++, item);
  return file;
}

}  // namespace furrow::exchange
