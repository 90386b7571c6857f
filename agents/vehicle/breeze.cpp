#include "agents/vehicle/breeze.hpp"

#include "agents/control_clock.hpp"
#include "agents/vehicle/normal_pair.hpp"

namespace furrow::agents {
namespace {

constexpr double correlation_s = 5.0;

Xy mean_velocity(const Wind& wind) {
  const double from_rad = wind.from_deg * std::numbers::pi / 180.0;
  return -wind.mean.base() * Xy{std::sin(from_rad), std::cos(from_rad)};
}

}  // namespace

Breeze::Breeze(const Wind& wind, std::uint64_t seed)
    : mean_{mean_velocity(wind)},
      sigma_{wind.gust.base()},
      keep_{std::exp(-control_period_s / correlation_s)},
      stir_{sigma_ * std::sqrt(1.0 - keep_ * keep_)},
      random_{seed} {}

Xy Breeze::at_take_off() {
  gust_ = sigma_ > 0.0 ? sigma_ * normal_pair(random_) : Xy{};
  return mean_ + gust_;
}

Xy Breeze::next() {
  if (sigma_ > 0.0) gust_ = keep_ * gust_ + stir_ * normal_pair(random_);
  return mean_ + gust_;
}

}  // namespace furrow::agents
