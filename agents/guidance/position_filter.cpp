#include "agents/guidance/position_filter.hpp"

#include "agents/control_clock.hpp"
#include "agents/gnss/receiver.hpp"

namespace furrow::agents {

PositionFilter::PositionFilter(double sigma_m) : gain_{1.0} {
  const double drift_m = velocity_sigma_mps * control_period_s;  // what a period of velocity adds
  if (sigma_m <= 0.0) return;
  const double ratio = drift_m / sigma_m;
  gain_ = 0.5 * ratio * (std::sqrt(ratio * ratio + 4.0) - ratio);
}

void PositionFilter::predict(Xy velocity_mps) {
  estimate_ = estimate_ + control_period_s * velocity_mps;
}

}  // namespace furrow::agents
