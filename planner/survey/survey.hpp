#pragma once
// A survey: way points are visited, nothing is sprayed.

#include "core/vehicle.hpp"
#include "planner/coverage/route.hpp"
#include "planner/routes/plan_route.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace furrow::planner {

struct SurveySettings {
  std::vector<FieldPoint> way_points;  ///< At least one, no two the same.
  Length height = metres(30);          ///< Above the ground, at way points and as work height.
  RouteSettings search{};              ///< Of each way from one to the next.
};

/// What the ways of a survey keep to.
struct SurveyRule {
  const Field& field;    ///< They stay over it, and out of its obstacles whatever their height.
  Length apart{};        ///< Further from volumes and obstacles by this, >= 0.
  Speed speed;           ///< Of the fastest aircraft on its way.
  Length turn_radius{};  ///< The largest of the fleet's, >= 0.
};

/// The way points in the order of a short tour from `from`, by their places among them.
/// @pre `ferries` reaches all way points.
std::vector<std::uint32_t> survey_tour(const SurveySettings& survey, const FerryMap& ferries,
                                       FieldPoint from);

/// The way points as a route to be shared: in the given order, each with the way that leads to it.
///
/// Over terrain such a way is searched in the air (see `plan_route`), as level as aircraft fly at
/// full speed, or else as steep as they may. It keeps the clearance, or the height of way points
/// where that is less. Where the search finds none, or one that leaves the land, the way is the
/// shortest over the land, at work height above the ground.
///
/// @param ferries  Of the fleet, its relief flown at the survey's height.
/// @param order    Every way point once, by its place.
/// @pre `ferries` reaches all way points.
Route survey_route(const SurveySettings& survey, const SurveyRule& rule, const FerryMap& ferries,
                   std::span<const std::uint32_t> order);

}  // namespace furrow::planner
