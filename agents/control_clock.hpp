#pragma once
// The grid of mission time on which an aircraft senses, decides and moves.

#include "core/time.hpp"

namespace furrow::agents {

inline constexpr Duration control_period{100'000'000};
inline constexpr double control_period_s = 0.1;
inline constexpr Duration whole_second{1'000'000'000};

/// The first instant of the grid of `period` that is not before `t`. Mission time is not negative.
constexpr Instant on_grid(Instant t, Duration period) {
  const auto since = t.time_since_epoch();
  const auto steps = (since.count() + period.count() - 1) / period.count();
  return Instant{steps * period};
}

/// The first instant of the grid of `period` after `t`.
constexpr Instant next_on_grid(Instant t, Duration period) {
  return on_grid(t + Duration{1}, period);
}

}  // namespace furrow::agents
