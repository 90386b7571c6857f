#include "app/results/sweep_coverage.hpp"

#include <algorithm>

namespace furrow::app {
namespace {

// A track point tells what the valve does from there on; a flown place, what it did on the way.
std::vector<planner::FlownPlace> places(const std::vector<TrackPoint>& track) {
  std::vector<planner::FlownPlace> all;
  bool is_open = false;
  Length width;
  for (const TrackPoint& point : track) {
    all.push_back({point.position, is_open, width});
    is_open = point.spraying;
    width = point.width;
  }
  return all;
}

std::vector<planner::FlownPlace> places(const planner::Route& route) {
  std::vector<planner::FlownPlace> all;
  for (const planner::Strip& strip : route.strips) {
    // The valve stays open over a corner that two strips share.
    const bool goes_on = !all.empty() && distance(all.back().at, strip.begin) <= metres(1e-9);
    if (!goes_on) all.push_back({strip.begin, false});
    all.push_back({strip.end, true, strip.width});
  }
  return all;
}

}  // namespace

std::vector<SeenObstacle> seen_obstacles(const std::vector<Envelope>& log) {
  std::vector<SeenObstacle> seen;
  for (const Envelope& e : log) {
    const auto* sighting = std::get_if<ObstacleSeen>(&e.body);
    if (sighting == nullptr) continue;
    const bool is_known = std::find(seen.begin(), seen.end(), sighting->obstacle) != seen.end();
    if (!is_known) seen.push_back(sighting->obstacle);
  }
  return seen;
}

MetFigures met_figures(const std::vector<Envelope>& log) {
  MetFigures figures{.obstacles = seen_obstacles(log).size()};
  for (const Envelope& e : log) {
    const auto* event = std::get_if<Event>(&e.body);
    if (event == nullptr) continue;
    if (event->kind == "detour_sprayed") ++figures.detours;
    if (event->kind == "detour_closed") ++figures.closed;
    if (event->kind == "way_blocked") ++figures.blocked;
  }
  return figures;
}

Field known_field(const MissionRecord& record) {
  Field field = record.scenario.field;
  for (const SeenObstacle& o : seen_obstacles(record.log)) {
    field.obstacles.push_back({.id = "met in flight", .center = o.center, .radius = o.radius});
  }
  return field;
}

std::vector<std::vector<planner::FlownPlace>> sprayed_tracks(const MissionRecord& record,
                                                             const Flown* flown) {
  if (flown == nullptr) return {places(record.plan.route)};
  std::vector<std::vector<planner::FlownPlace>> tracks;
  for (const FlownUav& uav : flown->uavs) tracks.push_back(places(uav.track));
  return tracks;
}

planner::SprayedAreas sweep_areas(const MissionRecord& record, const Flown* flown) {
  if (flown == nullptr) return record.plan.sweep->areas;
  const auto tracks = sprayed_tracks(record, flown);
  const auto areas = [&](const Field& field) {
    const auto coverage =
        planner::flown_coverage(field, record.scenario.uavs.front().swath, tracks);
    return coverage ? coverage->areas : planner::SprayedAreas{};  // the plan has judged the field
  };
  planner::SprayedAreas made = areas(record.scenario.field);
  const Field known = known_field(record);
  const bool met_some = known.obstacles.size() > record.scenario.field.obstacles.size();
  if (met_some) made.missed = areas(known).missed;  // what was sprayed there before stays sprayed
  return made;
}

CoverageFigures sweep_coverage(const CoverageFigures& cells, const planner::SweepFigures& sweep,
                               const planner::SprayedAreas& areas) {
  CoverageFigures figures = cells;
  figures.covered_m2 = areas.covered.base();
  figures.missed_m2 = areas.missed.base();
  figures.repeated_m2 = areas.repeated.base();
  figures.outside_m2 = areas.outside.base();
  figures.unrouted_m2 = sweep.areas.missed.base();
  return figures;
}

}  // namespace furrow::app
