#pragma once

#include "exchange/missions.hpp"
#include "scheduler/fleet_plan.hpp"

#include <vector>

namespace furrow::app {

/// The sorties of a plan as other tools fly them: where, and with the valve open or closed. In
/// order of aircraft and sortie.
std::vector<exchange::SortieTrack> sortie_tracks(const scheduler::FleetPlan& plan);

}  // namespace furrow::app
