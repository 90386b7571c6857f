#include "planner/returns/cost.hpp"

#include <algorithm>

namespace furrow::planner {

ReturnCost::ReturnCost(const ReturnProblem& problem)
    : limits_{limits_of(problem)},
      spray_mps_{problem.vehicle.spray_speed.base()},
      range_m_{tank_range(problem.vehicle).base()},
      swap_s_{problem.station.battery_swap.base()},
      fill_base_s_{problem.station.fill_base.base()},
      fill_rise_s_{(problem.station.fill_full - problem.station.fill_base).base()} {
  const auto n = static_cast<std::uint32_t>(problem.spray_m.size());
  for (std::uint32_t i = 0; i < n; ++i) {
    cells_.push_back({.spray_m = problem.spray_m[i],
                      .back_s = problem.back_s(i),
                      .resume_m = problem.resume_m[i],
                      .leave_s = problem.out_s(i) - (problem.resume_s[i] - problem.on_route_s[i]),
                      .route_s = problem.route_pack_s(i),
                      .resume_s = problem.resume_pack_s(i),
                      .out_s = problem.out_pack_s(i),
                      .home_s = problem.back_pack_s(i)});
  }
  for (std::uint32_t i = 0, j = 0; i < n; ++i) {
    while (j + 1 < n && spray_m(i, j + 1) <= limits_.tank_m) ++j;
    tank_reach_.push_back(j);
    std::uint32_t reach = j;
    while (reach > i && flight_s(i, reach) > limits_.pack_s) --reach;
    reach_.push_back(reach);
  }
}

JudgedReturns ReturnCost::operator()(std::span<const std::uint32_t> returns) const {
  JudgedReturns judged{.non_spray_s = 0.0, .excess_s = 0.0};
  double used_s = 0.0;  // of the pack on board
  std::uint32_t first = 0;
  for (std::size_t n = 0; n <= returns.size(); ++n) {
    const std::uint32_t last = n < returns.size() ? returns[n] : last_cell();
    const double flight = flight_s(first, last);
    const double sprayed_m = spray_m(first, last);
    if (n > 0) {
      const bool swap = used_s + flight > limits_.pack_s;
      if (swap) used_s = 0.0;
      // Summed in the order of `evaluated`, so that both give the same bits.
      judged.non_spray_s += service_s(sprayed_m, swap) + back_s(first) + leave_s(first);
    }
    used_s += flight;
    if (sprayed_m > limits_.tank_m) judged.excess_s += (sprayed_m - limits_.tank_m) / spray_mps_;
    if (flight > limits_.pack_s) judged.excess_s += flight - limits_.pack_s;
    first = last;
  }
  return judged;
}

}  // namespace furrow::planner
