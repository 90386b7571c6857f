#pragma once

#include "agents/guidance/height_profile.hpp"
#include "agents/guidance/pace.hpp"
#include "core/messages.hpp"
#include "planner/terrain/relief.hpp"

#include <vector>

namespace furrow::agents {

/// Where an aircraft is on its way.
struct Underway {
  Pace pace;
  double altitude_m;
  Instant at;
};

/// Where it will be if nothing holds it up, once it flies on towards `to_m` along its path: every
/// half second, but where it flies straight and evenly, within 0.1 m.
/// @return  From where it is on; two places at least.
std::vector<TimedPlace> coming_track(Underway from, const Path& path, const HeightProfile& heights,
                                     const planner::HeightRule& rule, double to_m);

/// The height a control period later, towards a height: no faster than the rule lets it climb and
/// descend, with a fifth in hand.
double next_altitude_m(double altitude_m, double wanted_m, const planner::HeightRule& rule);

}  // namespace furrow::agents
