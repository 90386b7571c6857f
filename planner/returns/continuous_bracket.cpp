#include "planner/returns/continuous_bracket.hpp"

#include "planner/returns/legs.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace furrow::planner {
namespace {

double cell_m(const Legs& legs, std::uint32_t i) {
  return i == 0 ? legs.spray_m[0] : legs.spray_m[i] - legs.spray_m[i - 1];
}

// How near to the station a place within cell i may be. Entry 0 of the resumes is the beginning of
// the share, seen from the aircraft's first position.
double least_m(const ReturnProblem& problem, std::uint32_t i, double cell_m) {
  const double end_m = problem.back_m[i];
  if (cell_m <= 0.0) return end_m;
  const double least_m = i < 2 ? end_m - cell_m : 0.5 * (problem.out_m[i - 1] + end_m - cell_m);
  return std::max(0.0, least_m);
}

Legs relaxed(const ReturnProblem& problem) {
  const double ferry_mps = problem.vehicle.ferry_speed.base();
  Legs legs = legs_of(problem);
  double longest_m = 0.0;
  for (std::uint32_t i = 0; i <= legs.last; ++i) longest_m = std::max(longest_m, cell_m(legs, i));

  legs.tank_m += longest_m;
  legs.fill_base_s -= longest_m * legs.fill_s_per_m;
  std::uint32_t end = 0;
  std::vector<double> trips_s;
  for (std::uint32_t i = 0; i <= legs.last; ++i) {
    const double trip_s =
        std::min(2.0 * least_m(problem, i, cell_m(legs, i)) / ferry_mps, legs.trip_s(i));
    trips_s.push_back(trip_s);
    while (end < legs.last && legs.spray_m[end + 1] - problem.resume_m[i] <= legs.tank_m) ++end;
    legs.reach[i] = end;
  }
  for (std::uint32_t i = 0; i <= legs.last; ++i) {  // only their sum counts
    legs.back_s[i] = legs.leave_s[i] = 0.5 * trips_s[i];
  }
  return legs;
}

// Cells of a quarter of a metre bound a plan to a hundredth of a per cent; more than this many are
// not worth their time.
constexpr double fine_cell_m = 0.25;
constexpr double most_fine_cells = 4e6;

// A return problem that grows place by place along a route.
class FineProblem {
 public:
  explicit FineProblem(const ReturnProblem& coarse) : made_{coarse} {
    for (auto* list : {&made_.spray_m, &made_.on_route_s, &made_.back_m, &made_.resume_m,
                       &made_.resume_s, &made_.out_m}) {
      list->clear();
    }
    made_.strip_starts = {0};
  }

  void add(double spray_m, double on_route_s, double back_m, double resume_s, double out_m) {
    made_.spray_m.push_back(spray_m);
    made_.on_route_s.push_back(on_route_s);
    made_.back_m.push_back(back_m);
    made_.resume_m.push_back(spray_m);
    made_.resume_s.push_back(resume_s);
    made_.out_m.push_back(out_m);
  }

  ReturnProblem taken() {
    made_.resume_m[0] = made_.resume_s[0] = 0.0;
    made_.out_m[0] = made_.fly_out_m;
    return std::move(made_);
  }

 private:
  ReturnProblem made_;
};

// `coarse` with every cell cut into `parts`. The way home from within a cell is no shorter than the
// straight one, nor than that from an end of the cell less the distance to it.
ReturnProblem finer(const Route& route, const ReturnProblem& coarse, std::uint32_t parts) {
  const double spray_mps = coarse.vehicle.spray_speed.base();
  const double ferry_mps = coarse.vehicle.ferry_speed.base();
  FineProblem fine{coarse};
  for (std::uint32_t i = 0; i < coarse.cells.count; ++i) {
    const std::uint32_t cell = coarse.cells.first + i;
    const std::size_t s = strip_of(route, cell);
    const Strip& strip = route.strips[s];
    const FieldPoint from = start_point(route, strip, cell), to = stop_point(route, strip, cell);
    const double length_m = cell_length(route, strip).base();
    const bool knows_start = i > 0 && cell > strip.cells.first;
    for (std::uint32_t p = 1; p < parts; ++p) {
      const double share = static_cast<double>(p) / parts;
      const FieldPoint at = from + FieldVector{share * (to - from).x, share * (to - from).y};
      const double left_m = (1.0 - share) * length_m;
      double home_m =
          std::max(distance(at, coarse.station.position).base(), coarse.back_m[i] - left_m);
      if (knows_start) home_m = std::max(home_m, coarse.back_m[i - 1] - share * length_m);
      const double passed_s = coarse.on_route_s[i] - left_m / spray_mps;
      fine.add(coarse.spray_m[i] - left_m, passed_s, home_m, passed_s, home_m);
    }
    const double stop_s = coarse.on_route_s[i];
    if (i > 0) {
      fine.add(coarse.spray_m[i], stop_s, coarse.back_m[i], coarse.resume_s[i], coarse.out_m[i]);
    } else if (cell + 1 < end(strip.cells) || s + 1 == route.strips.size()) {
      fine.add(coarse.spray_m[i], stop_s, coarse.back_m[i], stop_s, coarse.back_m[i]);
    } else {  // a first strip of one cell: the problem holds no return after it
      const Strip& next = route.strips[s + 1];
      fine.add(coarse.spray_m[i], stop_s, coarse.back_m[i],
               stop_s + approach_length(strip, next).base() / ferry_mps,
               distance(next.begin, coarse.station.position).base());
    }
  }
  return fine.taken();
}

std::uint32_t fine_parts(const Route& route, const ReturnProblem& problem) {
  const double wanted = std::ceil(route.cell.base() / fine_cell_m);
  const double most = most_fine_cells / static_cast<double>(problem.cells.count);
  return static_cast<std::uint32_t>(std::max(1.0, std::min(wanted, std::floor(most))));
}

Expected<ContinuousBracket, PlanError> bracket(const ReturnProblem& problem,
                                               const ReturnProblem& bounding,
                                               const ExactSettings& settings) {
  auto upper = exact_plan(problem, settings);
  if (!upper) return Unexpected{upper.error()};
  const double lower_s =
      std::min(battery_free(relaxed(bounding)).optimum_s, upper->plan.non_spray_s);
  const double ferry_mps = problem.vehicle.ferry_speed.base();
  const double flown_s =
      problem.fly_out_m / ferry_mps + problem.on_route_s.back() + problem.back_m.back() / ferry_mps;
  const double upper_s = upper->plan.non_spray_s;
  return ContinuousBracket{.upper = std::move(*upper),
                           .lower_s = lower_s,
                           .mission_upper_s = flown_s + upper_s,
                           .mission_lower_s = flown_s + lower_s};
}

}  // namespace

Expected<ContinuousBracket, PlanError> continuous_bracket(const ReturnProblem& problem,
                                                          const ExactSettings& settings) {
  return bracket(problem, problem, settings);
}

Expected<ContinuousBracket, PlanError> continuous_bracket(const Route& route,
                                                          const ReturnProblem& problem,
                                                          const ExactSettings& settings) {
  return bracket(problem, finer(route, problem, fine_parts(route, problem)), settings);
}

}  // namespace furrow::planner
