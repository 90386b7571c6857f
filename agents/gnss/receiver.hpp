#pragma once

#include "agents/xy.hpp"
#include "core/random.hpp"
#include "core/vehicle.hpp"

#include <cstdint>

namespace furrow::agents {

/// A positioning receiver: every fix is off by one bias for the whole run and by white noise.
class Receiver {
 public:
  Receiver(const Gnss& gnss, std::uint64_t seed);

  Xy fix_m(Xy truth_m);

  /// The mean of a hundred fixes, as a receiver that has stood still for ten seconds gives it.
  Xy settled_fix_m(Xy truth_m);

  /// Velocity from carrier phase, good to 0.05 m/s on each axis.
  Xy velocity_mps(Xy truth_mps);

 private:
  double sigma_;
  Random random_;
  Xy bias_;
};

/// Standard deviation of each axis of a measured velocity.
inline constexpr double velocity_sigma_mps = 0.05;

}  // namespace furrow::agents
