#pragma once

#include "core/units.hpp"

namespace furrow {

/// The wind over the field.
struct Wind {
  Speed mean;
  double from_deg;  ///< Where it blows from, clockwise from north.
  Speed gust;       ///< Standard deviation of the turbulence on each axis.
};

}  // namespace furrow
