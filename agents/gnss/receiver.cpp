#include "agents/gnss/receiver.hpp"

#include "agents/vehicle/normal_pair.hpp"

namespace furrow::agents {

Receiver::Receiver(const Gnss& gnss, std::uint64_t seed)
    : sigma_{gnss.sigma.base()}, random_{seed} {
  const double direction = random_.uniform(0.0, 2.0 * std::numbers::pi);
  bias_ = gnss.bias.base() * Xy{std::sin(direction), std::cos(direction)};
}

Xy Receiver::fix_m(Xy truth_m) { return truth_m + bias_ + sigma_ * normal_pair(random_); }

Xy Receiver::settled_fix_m(Xy truth_m) {
  return truth_m + bias_ + (0.1 * sigma_) * normal_pair(random_);
}

Xy Receiver::velocity_mps(Xy truth_mps) {
  return truth_mps + velocity_sigma_mps * normal_pair(random_);
}

}  // namespace furrow::agents
