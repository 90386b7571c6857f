#pragma once

#include <cmath>

namespace furrow::app {

/// The nearest whole micro-unit, without a negative zero: the number rule of every result file.
inline double rounded(double value) { return std::round(value * 1e6) / 1e6 + 0.0; }

}  // namespace furrow::app
