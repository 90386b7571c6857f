#pragma once
// Missions out: one file per aircraft and sortie, in WGS84, for the tools of others.

#include "core/field.hpp"
#include "core/ids.hpp"
#include "exchange/local_frame.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace furrow::exchange {

/// A place to fly over, and what the valve does from there on.
struct TrackPoint {
  FieldPoint at;
  bool is_spraying;
  Length width{};     ///< Of the spray, where only a part of the boom is open; 0: all of it.
  Length altitude{};  ///< Above home.
  Length ground{};    ///< Of the ground there, above home.
};

/// One trip of one aircraft: from home over the points to the place where it lands.
struct SortieTrack {
  AgentId uav;
  std::uint32_t sortie;  ///< From 1.
  FieldPoint home;       ///< Where it takes off.
  FieldPoint landing;    ///< Where it lands: the station that serves it next, or its last.
  std::vector<TrackPoint> points;  ///< At least one. The valve closes at the last at the latest.
  Length take_off;                 ///< So high above home, > 0, before the first point.
  Length landing_ground{};         ///< Of the landing place, above home.
  Speed spray_speed, ferry_speed;  ///< > 0
};

enum class MissionFormat { qgc_plan, waypoints, geojson, kml, csv };

/// The format called "qgc-plan", "waypoints", "geojson", "kml" or "csv".
std::optional<MissionFormat> mission_format(std::string_view name);

/// Whether files of this format tell how much of the boom is open.
bool tells_width(MissionFormat format);

/// "uav1_sortie2.plan", with the extension of the format.
std::string file_name(const SortieTrack& track, MissionFormat format);

/// The format of the file that `file_name` names so, of whatever aircraft and sortie; none for
/// other names.
std::optional<MissionFormat> format_of_file(std::string_view file_name);

/// The sortie as a file; coordinates to 1e-9 degrees.
///
/// qgc_plan and waypoints hold MAVLink items: take-off, speed, waypoints, DO_SPRAYER in pairs of
/// on and off, land at the landing place. An item that acts is placed behind the waypoint where it
/// acts. geojson and kml hold one line per stretch of one valve state, csv one row per point, all
/// with home first and the landing place last. Only geojson and csv tell the width of the spray.
/// Heights are above home, in kml above the ground.
std::string mission_file(const SortieTrack& track, const LocalFrame& frame, MissionFormat format);

}  // namespace furrow::exchange
