#include "planner/returns/legs.hpp"

#include "planner/returns/limits.hpp"
#include "planner/returns/sliding_minimum.hpp"

#include <algorithm>

namespace furrow::planner {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// A leg costs less than `fill_base_s + fill_s_per_m * length` only where it sprays nothing: from
// the end of a strip to the start of the next across a jump. Calls `f(j)` for each such end.
template <class F>
void for_each_dry_end(const Legs& legs, std::uint32_t i, F f) {
  for (std::uint32_t j = i + 1; j <= legs.last && legs.spray_m[j] <= legs.spray_m[i]; ++j) f(j);
}

std::vector<double> after(const Legs& legs) {
  std::vector<double> after_s(legs.last + 1, 0.0);
  SlidingMinimum ends;
  for (std::uint32_t i = legs.last; i-- > 0;) {
    const std::uint32_t j = i + 1;
    ends.push(j, legs.fill_s_per_m * legs.spray_m[j] + legs.arrival_s(j) + after_s[j]);
    ends.drop([&](std::uint32_t p) { return p > legs.reach[i]; });
    double best = ends.least() + legs.fill_base_s - legs.fill_s_per_m * legs.spray_m[i];
    for_each_dry_end(
        legs, i, [&](std::uint32_t d) { best = std::min(best, legs.arrival_s(d) + after_s[d]); });
    after_s[i] = legs.leave_s[i] + best;
  }
  return after_s;
}

std::vector<double> until(const Legs& legs) {
  std::vector<double> until_s(legs.last + 1, infinite);
  SlidingMinimum starts;
  for (std::uint32_t j = 1; j <= legs.last; ++j) {
    const std::uint32_t i = j - 1;
    if (i > 0) starts.push(i, until_s[i] + legs.leave_s[i] - legs.fill_s_per_m * legs.spray_m[i]);
    starts.drop([&](std::uint32_t p) { return legs.reach[p] < j; });
    double best = starts.least() + legs.fill_base_s + legs.fill_s_per_m * legs.spray_m[j];
    if (legs.reach[0] >= j) best = std::min(best, 0.0);
    for (std::uint32_t d = j; d-- > 1 && legs.spray_m[d] >= legs.spray_m[j];) {
      best = std::min(best, until_s[d] + legs.leave_s[d]);
    }
    until_s[j] = best + legs.arrival_s(j);
  }
  return until_s;
}

}  // namespace

Legs legs_of(const ReturnProblem& problem) {
  const Limits limits = limits_of(problem);
  const auto n = static_cast<std::uint32_t>(problem.spray_m.size());
  const double fill_base_s = problem.station.fill_base.base();
  Legs legs{.last = n - 1,
            .spray_m = problem.spray_m,
            .route_s = {},
            .back_s = {},
            .leave_s = {},
            .back_pack_s = {},
            .leave_pack_s = {},
            .landing_s = {},
            .reach = std::vector<std::uint32_t>(n),
            .first_offset_s = problem.out_pack_s(0),
            .tank_m = limits.tank_m,
            .pack_s = limits.pack_s,
            .swap_s = problem.station.battery_swap.base(),
            .fill_base_s = fill_base_s,
            .fill_s_per_m = (problem.station.fill_full.base() - fill_base_s) /
                            tank_range(problem.vehicle).base()};
  std::uint32_t end = 0;
  for (std::uint32_t i = 0; i < n; ++i) {
    legs.route_s.push_back(problem.route_pack_s(i));
    legs.back_s.push_back(problem.back_s(i));
    legs.leave_s.push_back(problem.out_s(i) - (problem.resume_s[i] - problem.on_route_s[i]));
    legs.back_pack_s.push_back(problem.back_pack_s(i));
    legs.leave_pack_s.push_back(problem.out_pack_s(i) -
                                (problem.resume_pack_s(i) - problem.route_pack_s(i)));
    legs.landing_s.push_back(legs.route_s[i] + legs.back_pack_s[i]);
    while (end + 1 < n && legs.spray_m[end + 1] - problem.resume_m[i] <= legs.tank_m) ++end;
    legs.reach[i] = end;
  }
  return legs;
}

BatteryFree battery_free(const Legs& legs) {
  BatteryFree free{.until_s = until(legs), .after_s = after(legs), .optimum_s = 0.0};
  if (legs.last > 0) free.optimum_s = free.until_s[legs.last];
  return free;
}

Returns battery_free_returns(const Legs& legs, const BatteryFree& free) {
  Returns returns;
  constexpr double worth_a_return_s = 1e-9;  // less is rounding
  for (std::uint32_t at = 0;;) {
    std::uint32_t best = at;
    double best_s = infinite;
    if (legs.reach[at] == legs.last) {
      best_s = (at == 0 ? 0.0 : legs.fill_s(at, legs.last)) - worth_a_return_s;
    }
    for (std::uint32_t j = at + 1; j <= legs.reach[at] && j < legs.last; ++j) {
      const double service_s = at == 0 ? 0.0 : legs.fill_s(at, j);
      const double cost_s = service_s + legs.arrival_s(j) + free.after_s[j];
      if (cost_s < best_s) {
        best_s = cost_s;
        best = j;
      }
    }
    if (best == at) return returns;
    returns.push_back(at = best);
  }
}

}  // namespace furrow::planner
