#include "app/exports/missions_json.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace furrow::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr int version = 3;  // 2 knew one height of a sortie, 1 no landing place

Json point(FieldPoint p) { return Json::array({p.x.base(), p.y.base()}); }

FieldPoint point(const Json& json) { return at_m(json.at(0), json.at(1)); }

Json to_json(const exchange::SortieTrack& track) {
  Json points = Json::array();
  for (const exchange::TrackPoint& p : track.points) {
    points.push_back(
        {p.at.x.base(), p.at.y.base(), p.altitude.base(), p.ground.base(), p.is_spraying ? 1 : 0});
    if (p.width > Length{}) points.back().push_back(p.width.base());
  }
  return {{"uav", number(track.uav)},
          {"sortie", track.sortie},
          {"home_m", point(track.home)},
          {"landing_m", point(track.landing)},
          {"take_off_m", track.take_off.base()},
          {"landing_ground_m", track.landing_ground.base()},
          {"spray_speed_mps", track.spray_speed.base()},
          {"ferry_speed_mps", track.ferry_speed.base()},
          {"points", std::move(points)}};
}

exchange::SortieTrack track(const Json& json) {
  exchange::SortieTrack track{.uav = AgentId{json.at("uav").get<std::uint32_t>()},
                              .sortie = json.at("sortie"),
                              .home = point(json.at("home_m")),
                              .landing = point(json.at("landing_m")),
                              .points = {},
                              .take_off = metres(json.at("take_off_m")),
                              .landing_ground = metres(json.at("landing_ground_m")),
                              .spray_speed = metres_per_second(json.at("spray_speed_mps")),
                              .ferry_speed = metres_per_second(json.at("ferry_speed_mps"))};
  for (const Json& p : json.at("points")) {
    track.points.push_back({.at = point(p),
                            .is_spraying = p.at(4).get<int>() != 0,
                            .altitude = metres(p.at(2)),
                            .ground = metres(p.at(3))});
    if (p.size() > 5) track.points.back().width = metres(p.at(5));
  }
  return track;
}

}  // namespace

nlohmann::ordered_json datum_json(const std::optional<exchange::Datum>& datum) {
  if (!datum) return nullptr;
  return {{"lat_deg", datum->lat_deg}, {"lon_deg", datum->lon_deg}};
}

std::string missions_json(const Missions& missions) {
  Json sorties = Json::array();
  for (const exchange::SortieTrack& track : missions.sorties) sorties.push_back(to_json(track));
  const Json all{
      {"version", version}, {"datum", datum_json(missions.datum)}, {"sorties", std::move(sorties)}};
  return all.dump(1) + "\n";
}

Expected<Missions, std::string> read_missions(const std::string& json) {
  try {
    const Json all = Json::parse(json);
    if (const Json& found = all.at("version"); found != version) {
      return Unexpected{fmt::format("version: must be {} (got {}): plan the scenario again",
                                    version, found.dump())};
    }
    Missions missions{};
    if (const Json& datum = all.at("datum"); !datum.is_null()) {
      missions.datum =
          exchange::Datum{.lat_deg = datum.at("lat_deg"), .lon_deg = datum.at("lon_deg")};
    }
    for (const Json& sortie : all.at("sorties")) missions.sorties.push_back(track(sortie));
    return missions;
  } catch (const Json::exception& error) {
    const std::string cause = error.what();  // "[json.exception.type.id] cause"
    return Unexpected{"must be as plan, sim or run write it:" + cause.substr(cause.find(']') + 1)};
  }
}

}  // namespace furrow::app
