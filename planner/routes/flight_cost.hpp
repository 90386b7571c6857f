#pragma once

namespace furrow::planner {

/// Seconds of flight, and of the pack in seconds of level flight.
struct FlightCost {
  double time_s, energy_s;
  friend constexpr FlightCost operator+(FlightCost a, FlightCost b) {
    return {a.time_s + b.time_s, a.energy_s + b.energy_s};
  }
};

}  // namespace furrow::planner
