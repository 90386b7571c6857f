#pragma once

#include "planner/coverage/cover.hpp"
#include "planner/returns/solve.hpp"
#include "planner/survey/survey.hpp"
#include "planner/terrain/relief.hpp"

#include <optional>
#include <vector>

namespace furrow::scheduler {

/// A field to spray, or places to visit over it, and what there is to do so with.
struct FleetProblem {
  Field field;
  planner::CoverageModel coverage;           ///< Its direction is the next line's.
  std::optional<double> work_direction_deg;  ///< Clockwise from north; searched when left out.
  std::vector<Station> stations;             ///< At least one.
  std::vector<Vehicle> vehicles;             ///< At least one, ids rising, all of one swath.
  planner::SolveSettings solver;             ///< Its budget is for the whole fleet.
  std::optional<planner::TerrainModel> terrain{};  ///< None: level land.
  std::vector<Vehicle> joining{};  ///< Come after the start: they are given no share.
  /// Then way points are visited and nothing is sprayed; the terrain's work height is the survey's.
  std::optional<planner::SurveySettings> survey{};
  std::optional<Length> separation{};  ///< That aircraft in the air keep; none: any.
};

/// With those who come late, by id.
std::vector<Vehicle> whole_fleet(const FleetProblem& problem);

/// What every way keeps of every obstacle. Surveys over terrain are flown high above them all.
Length safety_of(const FleetProblem& problem);

/// How far before corners aircraft may leave their line to round them.
Length corner_cut(const FleetProblem& problem);

}  // namespace furrow::scheduler
