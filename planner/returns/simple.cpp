#include "planner/returns/simple.hpp"

#include "planner/returns/evaluate.hpp"
#include "planner/returns/furthest.hpp"

#include <algorithm>
#include <vector>

namespace furrow::planner {
namespace {

// For each strip, the cell after which to return at its end nearer to the station, in route order.
// Strips that are sprayed from end to end are left at their ends only, which is after the last cell
// of the strip before where the near end is the beginning.
std::vector<std::uint32_t> near_ends(const ReturnProblem& problem) {
  std::vector<std::uint32_t> ends;
  for (std::size_t s = 0; s < problem.strip_starts.size(); ++s) {
    const std::uint32_t first = problem.strip_starts[s];
    const auto last = static_cast<std::uint32_t>(s + 1 < problem.strip_starts.size()
                                                     ? problem.strip_starts[s + 1] - 1
                                                     : problem.spray_m.size() - 1);
    if (problem.spray_m[0] > 0.0) {
      const bool begins_nearer = first > 0 && problem.out_m[first - 1] < problem.back_m[last];
      ends.push_back(begins_nearer ? first - 1 : last);
    } else {
      ends.push_back(problem.back_m[first] < problem.back_m[last] ? first : last);
    }
  }
  return ends;
}

// The furthest end that one sortie from `at` carries to, or the furthest cell at all.
std::uint32_t next_return(const ReturnProblem& problem, const std::vector<std::uint32_t>& ends,
                          std::uint32_t at) {
  const std::uint32_t furthest = furthest_from(problem, at);
  if (furthest + 1 == problem.spray_m.size()) return furthest;
  auto end = std::upper_bound(ends.begin(), ends.end(), furthest);
  while (end != ends.begin() && *--end > at) {
    if (carries(problem, at, *end)) return *end;
  }
  return furthest;
}

}  // namespace

Expected<ReturnPlan, PlanError> simple_plan(const ReturnProblem& problem) {
  if (const auto error = infeasibility(problem)) return Unexpected{*error};
  const std::vector<std::uint32_t> ends = near_ends(problem);
  const auto last = static_cast<std::uint32_t>(problem.spray_m.size() - 1);
  Returns returns;
  for (std::uint32_t at = 0; (at = next_return(problem, ends, at)) < last;) returns.push_back(at);
  return evaluated(problem, returns);
}

}  // namespace furrow::planner
