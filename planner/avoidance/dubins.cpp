#include "planner/avoidance/dubins.hpp"

#include "core/require.hpp"

#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/DubinsStateSpace.h>

namespace furrow::planner {

CurveM dubins_curve(Pose from, Pose to, Length radius) {
  require(radius > Length{}, "a turn has a radius");
  namespace ob = ompl::base;
  const double radius_m = radius.base();
  const auto space = std::make_shared<ob::DubinsStateSpace>(radius_m);
  // Places near the origin keep their digits.
  const FieldVector way = to.at - from.at;
  ob::ScopedState<ob::SE2StateSpace> a{space}, b{space};
  a->setXY(0, 0);
  a->setYaw(wrapped_rad(from.heading_rad));
  b->setXY(way.x.base(), way.y.base());
  b->setYaw(wrapped_rad(to.heading_rad));
  const ob::DubinsStateSpace::DubinsPath word = space->dubins(a.get(), b.get());

  CurveM curve{{{from.at.x.base(), from.at.y.base()}, from.heading_rad}, {}};
  for (int i = 0; i < 3; ++i) {
    const double side = word.type_[i] == ob::DubinsStateSpace::DUBINS_LEFT    ? 1
                        : word.type_[i] == ob::DubinsStateSpace::DUBINS_RIGHT ? -1
                                                                              : 0;
    curve.bends.push_back({side / radius_m, word.length_[i] * radius_m});
  }
  return curve;
}

}  // namespace furrow::planner
