#include "app/results/sweep_coverage.hpp"

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

std::vector<std::vector<planner::FlownPlace>> sprayed_tracks(const MissionRecord& record,
                                                             const Flown* flown) {
  if (flown == nullptr) return {places(record.plan.route)};
  std::vector<std::vector<planner::FlownPlace>> tracks;
  for (const FlownUav& uav : flown->uavs) tracks.push_back(places(uav.track));
  return tracks;
}

planner::SprayedAreas sweep_areas(const MissionRecord& record, const Flown* flown) {
  if (flown == nullptr) return record.plan.sweep->areas;
  const auto coverage = planner::flown_coverage(
      record.scenario.field, record.scenario.uavs.front().swath, sprayed_tracks(record, flown));
  return coverage ? coverage->areas : planner::SprayedAreas{};  // the plan has judged the field
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
