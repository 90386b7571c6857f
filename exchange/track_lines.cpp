#include "exchange/track_lines.hpp"

#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace furrow::exchange {

namespace {

using nlohmann::json;

struct Stop {
  LinePoint place;
  bool is_spraying;  // from here on
  Length width{};
};

std::vector<Stop> stops(const SortieTrack& track, const LocalFrame& frame) {
  std::vector<Stop> stops{{{frame.to_wgs84(track.home), track.take_off, {}}, false}};
  for (const TrackPoint& point : track.points) {
    stops.push_back(
        {{frame.to_wgs84(point.at), point.altitude, point.ground}, point.is_spraying, point.width});
  }
  stops.back() = {stops.back().place, false};
  const Length ground = track.landing_ground;
  stops.push_back({{frame.to_wgs84(track.landing), ground + track.take_off, ground}, false});
  return stops;
}

double speed_mps(const SortieTrack& track, bool is_spraying) {
  return (is_spraying ? track.spray_speed : track.ferry_speed).base();
}

std::string title(const SortieTrack& track) {
  return fmt::format("UAV {} sortie {}", number(track.uav), track.sortie);
}

// To the millimetre: heights over terrain have no end of digits.
double height_m(Length height) { return std::round(1000 * height.base()) / 1000; }

std::string placemark(const TrackLine& line) {
  std::string coordinates;
  for (const LinePoint& p : line.points) {
    coordinates += fmt::format("{:.9f},{:.9f},{} ", p.at.lon_deg, p.at.lat_deg,
                               height_m(p.altitude - p.ground));
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
      lines.push_back({{all[i].place}, all[i].is_spraying, all[i].width});
    }
    lines.back().points.push_back(all[i + 1].place);
  }
  return lines;
}

std::string geojson(const SortieTrack& track, const LocalFrame& frame) {
  json features = json::array();
  for (const TrackLine& line : track_lines(track, frame)) {
    json coordinates = json::array();
    for (const LinePoint& p : line.points) {
      coordinates.push_back({p.at.lon_deg, p.at.lat_deg, height_m(p.altitude)});
    }
    features.push_back(
        {{"type", "Feature"},
         {"properties",
          {{"uav", number(track.uav)},
           {"sortie", track.sortie},
           {"part", features.size() + 1},
           {"spraying", line.is_spraying},
           {"speed_mps", speed_mps(track, line.is_spraying)}}},
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
    file += placemark(line);
  }
  return file + "</Document></kml>\n";
}

std::string csv(const SortieTrack& track, const LocalFrame& frame) {
  std::string file = "uav,sortie,point,lon_deg,lat_deg,altitude_m,spraying,speed_mps,width_m\n";
  std::size_t point = 0;
  for (const Stop& stop : stops(track, frame)) {
    file += fmt::format("{},{},{},{:.9f},{:.9f},{},{},{},{}\n", number(track.uav), track.sortie,
                        point++, stop.place.at.lon_deg, stop.place.at.lat_deg,
                        height_m(stop.place.altitude), stop.is_spraying ? 1 : 0,
                        speed_mps(track, stop.is_spraying),
                        stop.width > Length{} ? fmt::format("{}", stop.width.base()) : "");
  }
  return file;
}

}  // namespace furrow::exchange
