#pragma once

#include "planner/avoidance/crowd.hpp"

#include <vector>

namespace furrow::planner {

/// On which side the classic manoeuvre passes.
enum class ClassicSide {
  left,    ///< Always.
  nearer,  ///< Where the obstacle reaches less far.
};

/// Classic avoidance, the yardstick: straight up to the obstacle, a half circle around it on one
/// side, on along the line, valve open throughout, no look at the area. The half circle stands on
/// the line and holds what of the obstacle circle lies on its side; half circles that meet are
/// joined. An outline counts as the circle that holds it; where the half circles of a field with
/// outlines are not clear of them or leave it, `plan_avoidance` ends the row.
///
/// @return  The way of the pass, in legs of a few degrees. Turn radius, edges of the field and
///          neighbouring obstacles do not matter to it.
PathM classic_path(const PassM& pass, const std::vector<TargetM>& targets, ClassicSide side);

}  // namespace furrow::planner
