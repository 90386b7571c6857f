#pragma once

#include "exchange/missions.hpp"
#include "scheduler/fleet_plan.hpp"

#include <optional>
#include <vector>

namespace furrow::app {

/// The sorties of a plan as other tools fly them: where, and with the valve open or closed. In
/// order of aircraft and sortie.
/// @param survey_height  Above the ground, of a survey; else sorties are flown low over the crop.
std::vector<exchange::SortieTrack> sortie_tracks(const scheduler::FleetPlan& plan,
                                                 std::optional<Length> survey_height = {});

}  // namespace furrow::app
