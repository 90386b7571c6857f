#pragma once

#include "exchange/missions.hpp"

#include <string>
#include <vector>

namespace furrow::exchange {

/// A place with heights above home.
struct LinePoint {
  GeoPoint at;
  Length altitude, ground;
};

/// A stretch of a sortie flown with one valve state and width; neighbours share a point.
struct TrackLine {
  std::vector<LinePoint> points;  ///< At least 2.
  bool is_spraying;
  Length width;  ///< As of its points.
};

/// The sortie from home to landing, in order.
std::vector<TrackLine> track_lines(const SortieTrack& track, const LocalFrame& frame);

std::string geojson(const SortieTrack& track, const LocalFrame& frame);
std::string kml(const SortieTrack& track, const LocalFrame& frame);
std::string csv(const SortieTrack& track, const LocalFrame& frame);

}  // namespace furrow::exchange
