#pragma once

#include "mission/load.hpp"
#include "planner/plan_error.hpp"

namespace furrow::mission {

/// Why there is no plan, as an error of the scenario file: the key that an operator would change,
/// its line (of the map around it where the key is left out), the rule, and what is wrong with the
/// place, on the globe too where the field is there.
ScenarioError located(const planner::PlanError& error, const Scenario& scenario);

}  // namespace furrow::mission
