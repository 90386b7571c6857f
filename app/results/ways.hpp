#pragma once
// The ways of a mission, and how much of them led over no land.

#include "app/results/flown.hpp"

#include <vector>

namespace furrow::app {

using Way = std::vector<FieldPoint>;

/// How far off an aircraft with RTK may be: five standard deviations of a fix. A way along an edge
/// is therefore not outside.
inline constexpr Length edge_tolerance = metres(0.1);

/// Ways of one aircraft or of several.
struct MissionWays {
  std::vector<Way> whole;    ///< From take-off to landing.
  std::vector<Way> at_work;  ///< From where the valve first opens on a sortie to where it last
                             ///< closes, the connections between strips included.
};

/// As planned: by ferry ways from and to stations, along strips and approaches between.
MissionWays planned_ways(const planner::Route& route, const scheduler::UavPlan& uav);

/// As flown, by the true track. A sortie without a report counts until its track ends.
/// @param is_survey  At work is then from the first visit to the last.
MissionWays flown_ways(const FlownUav& uav, bool is_survey = false);

/// Those of all aircraft in one.
MissionWays together(const std::vector<MissionWays>& by_uav);

double length_m(const std::vector<Way>& ways);

/// Of all ways but those at work.
double ferry_m(const MissionWays& ways);

/// Length outside the field of `record`, inside holes or inside obstacles, beyond `edge_tolerance`.
double outside_m(const MissionRecord& record, const std::vector<Way>& ways);

}  // namespace furrow::app
