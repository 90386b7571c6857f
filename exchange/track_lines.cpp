#include "exchange/track_lines.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace furrow::exchange {

namespace {

using nlohmann::json;

struct Stop {
  GeoPoint at;
  bool is_spraying;  // from here on
  Length width{};
};

std::vector<Stop> stops(const SortieTrack& track, const LocalFrame& frame) {
  std::vector<Stop> stops{{frame.to_wgs84(track.home), false}};
  for (const TrackPoint& point : track.points) {
    stops.push_back({frame.to_wgs84(point.at), point.is_spraying, point.width});
  }
  stops.back() = {stops.back().at, false};
  stops.push_back({frame.to_wgs84(track.landing), false});
  return stops;
}

double speed_mps(const SortieTrack& track, bool is_spraying) {
  return (is_spraying ? track.spray_speed : track.ferry_speed).base();
}

std::string title(const SortieTrack& track) {
  return fmt::format("UAV {} sortie {}", number(track.uav), track.sortie);
}

std::string placemark(const TrackLine& line, double altitude_m) {
  std::string coordinates;
  for (const GeoPoint p : line.points) {
    coordinates += fmt::format("{:.9f},{:.9f},{} ", p.lon_deg, p.lat_deg, altitude_m);
  }
  const char* state = line.is_spraying ? "spray" : "ferry";
  return fmt::format(
      "<Placemark><name>{0}</name><styleUrl>#{0}</styleUrl><LineString>"
      "<altitudeMode>relativeToGround</altitudeMode><coordinates>{1}</coordinates>"
      "</LineString></Placemark>\n",
      state, coordinates);
}

}  // namespace

std::vector<TrackLine> track_lines(const SortieTrack& track, const LocalFrame& frame) {
  std::vector<TrackLine> lines;
  const std::vector<Stop> all = stops(track, frame);
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    if (lines.empty() || lines.back().is_spraying != all[i].is_spraying ||
        lines.back().width != all[i].width) {
      lines.push_back({{all[i].at}, all[i].is_spraying, all[i].width});
    }
    lines.back().points.push_back(all[i + 1].at);
  }
  return lines;
}

std::string geojson(const SortieTrack& track, const LocalFrame& frame) {
  json features = json::array();
  for (const TrackLine& line : track_lines(track, frame)) {
    json coordinates = json::array();
    for (const GeoPoint p : line.points) {
      coordinates.push_back({p.lon_deg, p.lat_deg, track.altitude.base()});
    }
    features.push_back(
        {{"type", "Feature"},
         {"properties",
          {{"uav", number(track.uav)},
           {"sortie", track.sortie},
           {"part", features.size() + 1},
           {"spraying", line.is_spraying},
           {"speed_mps", speed_mps(track, line.is_spraying)},
           {"altitude_m", track.altitude.base()}}},
         {"geometry", {{"type", "LineString"}, {"coordinates", std::move(coordinates)}}}});
    if (line.width > Length{}) features.back()["properties"]["width_m"] = line.width.base();
  }
  const json file{{"type", "FeatureCollection"}, {"features", std::move(features)}};
  return file.dump(2) + "\n";
}

std::string kml(const SortieTrack& track, const LocalFrame& frame) {
  std::string file = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document><name>{}</name>\n"
      "<Style id=\"spray\"><LineStyle><color>ff30a030</color><width>4</width></LineStyle></Style>\n"
      "<Style "
      "id=\"ferry\"><LineStyle><color>ff808080</color><width>2</width></LineStyle></Style>\n",
      title(track));
  for (const TrackLine& line : track_lines(track, frame)) {
    file += placemark(line, track.altitude.base());
  }
  return file + "</Document></kml>\n";
}

std::string csv(const SortieTrack& track, const LocalFrame& frame) {
  std::string file = "uav,sortie,point,lon_deg,lat_deg,altitude_m,spraying,speed_mps,width_m\n";
  std::size_t point = 0;
  for (const Stop& stop : stops(track, frame)) {
    file += fmt::format("{},{},{},{:.9f},{:.9f},{},{},{},{}\n", number(track.uav), track.sortie,
                        point++, stop.at.lon_deg, stop.at.lat_deg, track.altitude.base(),
                        stop.is_spraying ? 1 : 0, speed_mps(track, stop.is_spraying),
                        stop.width > Length{} ? fmt::format("{}", stop.width.base()) : "");
  }
  return file;
}

}  // namespace furrow::exchange
