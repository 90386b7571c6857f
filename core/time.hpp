#pragma once
// Time as the fleet keeps it. Nothing here can be asked for "now": the shell that runs a node
// tells it, so a simulated hour and a real one take the same path through the code.

#include "core/units.hpp"

#include <chrono>
#include <cmath>
#include <cstdint>

namespace furrow {

/// Nanoseconds since the mission's epoch. Integer, so equal instants compare equal on every
/// machine.
struct MissionClock {
  using rep = std::int64_t;
  using period = std::nano;
  using duration = std::chrono::duration<rep, period>;
  using time_point = std::chrono::time_point<MissionClock>;
  static constexpr bool is_steady = true;
};

using Duration = MissionClock::duration;
using Instant = MissionClock::time_point;

/// Later than anything that happens: the wake-up of a node that waits for messages only.
inline constexpr Instant never = Instant::max();

/// The nearest whole nanosecond.
inline Duration duration(Seconds s) { return Duration{std::llround(s.base() * 1e9)}; }
constexpr Seconds seconds(Duration d) { return seconds(static_cast<double>(d.count()) * 1e-9); }

/// Mission time as seconds since the epoch, and back.
constexpr Seconds seconds(Instant t) { return seconds(t.time_since_epoch()); }
inline Instant instant(Seconds s) { return Instant{duration(s)}; }

}  // namespace furrow
