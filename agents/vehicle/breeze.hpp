#pragma once

#include "agents/xy.hpp"
#include "core/random.hpp"
#include "core/weather.hpp"

#include <cstdint>

namespace furrow::agents {

/// The wind around one aircraft: a steady mean and gusts that forget themselves in 5 s.
/// Source: first-order Gauss-Markov turbulence, as in MIL-F-8785C, section 3.7.
class Breeze {
 public:
  Breeze(const Wind& wind, std::uint64_t seed);

  /// The wind when an aircraft leaves the ground: a fresh gust [m/s].
  Xy at_take_off();

  /// The wind one control period later [m/s].
  Xy next();

 private:
  Xy mean_, gust_;
  double sigma_, keep_, stir_;
  Random random_;
};

}  // namespace furrow::agents
