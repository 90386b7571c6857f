#pragma once

#include "agents/xy.hpp"
#include "core/random.hpp"

#include <cmath>
#include <numbers>

namespace furrow::agents {

/// Two independent numbers of mean 0 and standard deviation 1, for the price of one.
/// Source: Box, Muller 1958.
inline Xy normal_pair(Random& random) {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - random.uniform()));
  const double angle = 2.0 * std::numbers::pi * random.uniform();
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

}  // namespace furrow::agents
