#include "app/results/plan_geojson.hpp"

#include "app/exports/missions_json.hpp"
#include "app/results/rounding.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

namespace furrow::app {
namespace {

using Json = nlohmann::ordered_json;

Json position(FieldPoint p) { return Json::array({rounded(p.x.base()), rounded(p.y.base())}); }

double twice_signed_area_m2(const Ring& ring) {
  double sum = 0;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    sum += ring[j].x.base() * ring[i].y.base() - ring[i].x.base() * ring[j].y.base();
  }
  return sum;
}

// RFC 7946: closed, the outer ring counter-clockwise and holes clockwise.
Json linear_ring(Ring ring, bool is_outer) {
  if ((twice_signed_area_m2(ring) > 0) != is_outer) ring = Ring(ring.rbegin(), ring.rend());
  Json positions = Json::array();
  for (const FieldPoint p : ring) positions.push_back(position(p));
  positions.push_back(position(ring.front()));
  return positions;
}

Ring circle(FieldPoint center, double radius_m) {
  constexpr int corners = 36;
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    ring.push_back(at_m(center.x.base() + radius_m * std::cos(angle),
                        center.y.base() + radius_m * std::sin(angle)));
  }
  return ring;
}

Json feature(const char* type, Json coordinates, Json properties) {
  return {{"type", "Feature"},
          {"properties", std::move(properties)},
          {"geometry", {{"type", type}, {"coordinates", std::move(coordinates)}}}};
}

void add_land(Json& features, const mission::Scenario& scenario) {
  Json rings = Json::array({linear_ring(scenario.field.boundary, true)});
  for (const Ring& hole : scenario.field.holes) rings.push_back(linear_ring(hole, false));
  features.push_back(feature("Polygon", std::move(rings), {{"kind", "field"}}));
  for (const Obstacle& o : scenario.field.obstacles) {
    Json properties{{"kind", "obstacle"}, {"id", o.id}};
    if (o.outline.empty()) properties["radius_m"] = rounded(o.radius.base());
    const Ring ring = o.outline.empty() ? circle(o.center, o.radius.base()) : o.outline;
    features.push_back(
        feature("Polygon", Json::array({linear_ring(ring, true)}), std::move(properties)));
  }
  for (const Station& s : scenario.stations) {
    features.push_back(
        feature("Point", position(s.position),
                {{"kind", "supply_station"}, {"id", number(s.id)}, {"bays", s.bays}}));
  }
}

// A way point of a survey, with the way that leads to it within a sortie.
void add_visit(Json& features, const planner::Route& route, std::uint32_t index, std::uint32_t uav,
               bool is_first) {
  const planner::Strip& visit = route.strips[index];
  features.push_back(feature("Point", position(visit.begin),
                             {{"kind", "way_point"}, {"way_point", index + 1}, {"uav", uav}}));
  if (is_first) return;
  const planner::Relief* relief = route.ferries.relief();
  Json way = Json::array();
  const auto add = [&](FieldPoint at, std::size_t k) {
    way.push_back(position(at));
    if (relief == nullptr) return;
    const bool is_given = k < visit.approach_altitudes_m.size();
    way.back().push_back(
        rounded(is_given ? visit.approach_altitudes_m[k] : relief->work_altitude_m(at)));
  };
  add(route.strips[index - 1].end, visit.approach.size());
  for (std::size_t k = 0; k < visit.approach.size(); ++k) add(visit.approach[k], k);
  add(visit.begin, visit.approach.size());
  features.push_back(feature("LineString", std::move(way),
                             {{"kind", "way"}, {"to_way_point", index + 1}, {"uav", uav}}));
}

void add_work(Json& features, const planner::Route& route, const scheduler::UavPlan& uav) {
  const std::uint32_t id = number(uav.vehicle.id);
  for (std::uint32_t i = uav.strips.first; i < end(uav.strips); ++i) {
    const planner::Strip& strip = route.strips[i];
    if (planner::is_survey(route)) {
      add_visit(features, route, i, id, i == uav.strips.first);
      continue;
    }
    const bool is_whole = strip.width == Length{};
    features.push_back(
        feature("LineString", Json::array({position(strip.begin), position(strip.end)}),
                {{"kind", "strip"},
                 {"strip", i + 1},
                 {"uav", id},
                 {"swath_m", rounded((is_whole ? uav.vehicle.swath : strip.width).base())}}));
  }
  const auto& plan = uav.solution.plan;
  for (std::size_t k = 0; k < plan.returns.size(); ++k) {
    const std::uint32_t last = uav.cells.first + plan.returns[k];
    const FieldPoint at =
        planner::stop_point(route, route.strips[planner::strip_of(route, last)], last);
    Json properties{{"kind", "return_point"},
                    {"uav", id},
                    {"sortie", k + 1},
                    {"station", number(scheduler::landing(uav, k).id)}};
    if (k < plan.sorties.size()) properties["spray_m"] = rounded(plan.sorties[k].spray_m);
    features.push_back(feature("Point", position(at), std::move(properties)));
  }
}

}  // namespace

std::string plan_geojson(const MissionRecord& record) {
  Json features = Json::array();
  add_land(features, record.scenario);
  for (const scheduler::UavPlan& uav : record.plan.uavs) {
    add_work(features, record.plan.route, uav);
  }
  const double half_m = record.plan.route.cell.base() / 2;
  for (const FieldPoint p : record.plan.route.missed) {
    const double x_m = p.x.base(), y_m = p.y.base();
    const Ring cell{at_m(x_m - half_m, y_m - half_m), at_m(x_m + half_m, y_m - half_m),
                    at_m(x_m + half_m, y_m + half_m), at_m(x_m - half_m, y_m + half_m)};
    features.push_back(
        feature("Polygon", Json::array({linear_ring(cell, true)}), {{"kind", "missed_cell"}}));
  }
  const Json all{{"type", "FeatureCollection"},
                 {"name", record.scenario.name},
                 {"frame",
                  {{"axes", "east, north"},
                   {"unit", "metre"},
                   {"origin", "the scenario's own (0, 0)"},
                   {"datum", datum_json(record.scenario.datum)}}},
                 {"features", std::move(features)}};
  return all.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace furrow::app
