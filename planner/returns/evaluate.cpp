#include "planner/returns/evaluate.hpp"

#include "core/require.hpp"
#include "planner/returns/limits.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <functional>

namespace furrow::planner {
namespace {

/// The stations that a sortie leads from and to, as problems of one share.
struct Ends {
  const ReturnProblem& from;  ///< Any where the sortie is the first: that leaves from home.
  const ReturnProblem& to;
};

PlannedSortie flown(const Ends& ends, std::uint32_t first, std::uint32_t last) {
  return {.first = first,
          .last = last,
          .spray_m = ends.to.spray_m[last] - ends.to.resume_m[first],
          .fly_out_s = ends.from.out_s(first),
          .spray_s = ends.to.on_route_s[last] - ends.to.resume_s[first],
          .fly_back_s = ends.to.back_s(last),
          .pack = 1,
          .battery_used = 0.0,
          .battery_swap_s = 0.0,
          .fill_s = 0.0,
          .service_s = 0.0};
}

// Of a pack, in seconds of level flight.
double pack_s(const Ends& ends, const PlannedSortie& s) {
  return ends.from.out_pack_s(s.first) +
         (ends.to.route_pack_s(s.last) - ends.to.resume_pack_s(s.first)) +
         ends.to.back_pack_s(s.last);
}

std::uint32_t cell_count(const ReturnProblem& problem) {
  return static_cast<std::uint32_t>(problem.spray_m.size());
}

// The stay at a station between a sortie and the next, and what it adds to the plan.
void serve(ReturnPlan& plan, PlannedSortie& sortie, const PlannedSortie& next,
           const ReturnProblem& at, bool swap) {
  const double fill_share = next.spray_m / tank_range(at.vehicle).base();
  sortie.battery_swap_s = swap ? at.station.battery_swap.base() : 0.0;
  sortie.fill_s = fill_time(at.station, fill_share).base();
  sortie.service_s = service_time(at.station, swap, fill_share).base();
  const double skipped_s = at.resume_s[next.first] - at.on_route_s[next.first];
  plan.non_spray_s += sortie.service_s + sortie.fly_back_s + (next.fly_out_s - skipped_s);
  plan.round_trips_m += at.back_m[sortie.last] + at.out_m[next.first];
}

/// The stations that sortie `n` leads from and to.
Ends ends_of(std::span<const ReturnProblem* const> landings, std::size_t n) {
  return {.from = *landings[n == 0 ? 0 : n - 1], .to = *landings[n]};
}

/// The sorties between returns, nothing yet served.
ReturnPlan cut(std::span<const ReturnProblem* const> landings, const Returns& returns) {
  require(landings.size() == returns.size() + 1, "every sortie ends at a station");
  const std::uint32_t cells = cell_count(*landings.front());
  require(std::is_sorted(returns.begin(), returns.end(), std::less_equal<>{}) &&
              (returns.empty() || (returns.front() > 0 && returns.back() + 1 < cells)),
          "returns rise strictly between the first cell and the last");
  ReturnPlan plan{
      .returns = returns, .sorties = {}, .non_spray_s = 0, .round_trips_m = 0, .swaps = 0};
  plan.sorties.reserve(returns.size() + 1);
  std::uint32_t first = 0;
  for (const std::uint32_t last : returns) {
    plan.sorties.push_back(flown(ends_of(landings, plan.sorties.size()), first, last));
    first = last;
  }
  plan.sorties.push_back(flown(ends_of(landings, returns.size()), first, cells - 1));
  return plan;
}

/// What a sortie takes of its pack, and what has to be left for it to be begun.
struct Charge {
  double taken_s, wanted_s;
};

/// Serves the sorties of `plan`. `charge(n, takes_s)` judges what the problems say that the n-th
/// takes.
template <class ChargeOf>
ReturnPlan swapped(std::span<const ReturnProblem* const> landings, ReturnPlan plan,
                   ChargeOf charge) {
  const ReturnProblem& any = *landings.front();
  const Limits limits = limits_of(any);
  const auto charge_of = [&](std::size_t n) {
    return charge(n, pack_s(ends_of(landings, n), plan.sorties[n]));
  };
  double used_s = 0.0;  // of the pack on board
  Charge now = charge_of(0);
  for (std::size_t n = 0; n < plan.sorties.size(); ++n) {
    PlannedSortie& sortie = plan.sorties[n];
    sortie.pack = plan.swaps + 1;
    sortie.battery_used = now.taken_s / any.vehicle.flight_endurance.base();
    used_s += now.taken_s;
    if (n + 1 == plan.sorties.size()) break;

    now = charge_of(n + 1);
    const bool swap = used_s + now.wanted_s > limits.pack_s;
    if (swap) {
      used_s = 0.0;
      ++plan.swaps;
    }
    serve(plan, sortie, plan.sorties[n + 1], *landings[n], swap);
  }
  return plan;
}

}  // namespace

ReturnPlan evaluated(const ReturnProblem& problem, const Returns& returns) {
  return evaluated(std::vector<const ReturnProblem*>(returns.size() + 1, &problem), returns);
}

ReturnPlan evaluated(std::span<const ReturnProblem* const> landings, const Returns& returns) {
  return swapped(landings, cut(landings, returns), [](std::size_t, double takes_s) {
    return Charge{.taken_s = takes_s, .wanted_s = takes_s};
  });
}

ReturnPlan evaluated_as_flown(std::span<const ReturnProblem* const> landings,
                              const Returns& returns, std::span<const double> lost_s) {
  require(lost_s.size() == landings.size(), "every sortie loses some time, or none");
  return swapped(landings, cut(landings, returns), [lost_s](std::size_t n, double takes_s) {
    return Charge{.taken_s = takes_s + lost_s[n], .wanted_s = wanted_pack_s(takes_s + lost_s[n])};
  });
}

bool is_feasible(const ReturnProblem& problem, const ReturnPlan& plan) {
  const Limits limits = limits_of(problem);
  return std::all_of(plan.sorties.begin(), plan.sorties.end(), [&](const PlannedSortie& s) {
    const double taken_s = s.battery_used * problem.vehicle.flight_endurance.base();
    return s.spray_m <= limits.tank_m && taken_s <= limits.pack_s;
  });
}

std::optional<PlanError> infeasibility(const ReturnProblem& problem) {
  const Limits limits = limits_of(problem);
  const auto cell = [&](std::uint32_t i) { return problem.cells.first + i; };
  for (std::uint32_t i = 0; i < cell_count(problem); ++i) {
    const PlannedSortie least = flown({problem, problem}, i == 0 ? 0 : i - 1, i);
    if (least.spray_m > limits.tank_m) {
      return PlanError{PlanFault::tank_too_small,
                       fmt::format("UAV {}: cell {} takes {:.1f} m of spraying, a tank lasts for "
                                   "{:.1f} m",
                                   number(problem.vehicle.id), cell(i), least.spray_m,
                                   tank_range(problem.vehicle).base())};
    }
    if (pack_s({problem, problem}, least) > limits.pack_s) {
      return PlanError{
          PlanFault::out_of_reach,
          fmt::format("UAV {}: cell {} from station {} and back takes {:.1f} s of flight, a pack "
                      "lasts for {:.1f} s",
                      number(problem.vehicle.id), cell(i), number(problem.station.id),
                      pack_s({problem, problem}, least),
                      usable_endurance(problem.vehicle).base() - problem.kept_s),
          problem.station.position};
    }
  }
  return std::nullopt;
}

bool simple_plan_suffices(const ReturnProblem& problem, const ReturnPlan& unplanned,
                          const ReturnPlan& simple) {
  if (unplanned.sorties.size() != simple.sorties.size()) return false;
  double shorter_m = 0.0;
  for (std::size_t n = 0; n + 1 < unplanned.sorties.size(); ++n) {
    shorter_m += unplanned.sorties[n].spray_m - simple.sorties[n].spray_m;
  }
  return shorter_m <= limits_of(problem).tank_m - unplanned.sorties.back().spray_m;
}

}  // namespace furrow::planner
