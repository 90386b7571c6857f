#pragma once

#include "exchange/missions.hpp"

#include <array>
#include <vector>

namespace furrow::exchange {

/// One MAVLink MISSION_ITEM.
/// Source: MAVLink common message set, MAV_CMD and MAV_FRAME.
struct MissionItem {
  int frame;
  int command;
  std::array<double, 7> params;  ///< Of a place: params[4..6] are latitude, longitude, altitude.
};

namespace mavlink {
inline constexpr int frame_global = 0, frame_mission = 2, frame_relative_altitude = 3;
inline constexpr int waypoint = 16, land = 21, take_off = 22;
inline constexpr int change_speed = 178, sprayer = 216;
}  // namespace mavlink

/// What an autopilot does on a sortie, without the home item.
std::vector<MissionItem> mission_items(const SortieTrack& track, const LocalFrame& frame);

/// A QGroundControl plan file, format version 1.
std::string qgc_plan(const SortieTrack& track, const LocalFrame& frame);

/// An ArduPilot mission in the text format "QGC WPL 110"; item 0 is home.
std::string waypoints(const SortieTrack& track, const LocalFrame& frame);

}  // namespace furrow::exchange
