#pragma once

namespace furrow::planner {

/// Seconds of flight, and of the pack in seconds of level flight.
struct FlightCost {
  double time_s, energy_s;
};

}  // namespace furrow::planner
