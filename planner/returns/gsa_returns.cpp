#include "planner/returns/gsa_returns.hpp"

#include "core/random.hpp"
#include "core/require.hpp"
#include "planner/returns/simple.hpp"
#include "planner/search/gsa.hpp"

#include <algorithm>
#include <cmath>

namespace furrow::planner {
namespace {

// Tried on the 700 x 100 m field of Wang et al. 2017 with N = 50, T = 600, 40 seeds: the mean of
// one search is 18.84 to 18.87 min for G0 from 5 to 60, and 18.93 to 19.45 min with alpha = 20.
constexpr double g0 = 20.0, alpha = 10.0;
constexpr double least_share = 0.5;

}  // namespace

ShareCode::ShareCode(const ReturnProblem& problem, const ReturnCost& cost) : cost_{cost} {
  const double offset_m = problem.vehicle.swath.base();  // a cell at the station itself
  double sum = 0.0;
  for (const double d : problem.home_m) {
    sum += 1.0 / std::sqrt(d + offset_m);
    weight_.push_back(sum);
  }
}

void ShareCode::decode(std::span<const double> shares, Returns& returns) const {
  returns.clear();
  std::uint32_t at = 0;
  for (std::uint32_t reach; (reach = std::max(cost_.reach(at), at + 1)) < cost_.last_cell();) {
    const double share = returns.size() < shares.size() ? shares[returns.size()] : 1.0;
    const double target = weight_[at] + share * (weight_[reach] - weight_[at]);
    const auto from = weight_.begin() + at + 1, to = weight_.begin() + reach;
    auto next = static_cast<std::uint32_t>(std::lower_bound(from, to, target) - weight_.begin());
    while (next > at + 1 && !cost_.carries(at, next)) --next;
    returns.push_back(next);
    at = next;
  }
}

std::vector<double> ShareCode::encoded(std::span<const std::uint32_t> returns,
                                       std::size_t size) const {
  std::vector<double> shares(size, 1.0);
  std::uint32_t at = 0;
  for (std::size_t n = 0; n < std::min(size, returns.size()); ++n) {
    const double whole = weight_[std::max(cost_.reach(at), at + 1)] - weight_[at];
    // Half a cell short of the cell: safe against rounding either way.
    const std::uint32_t cell = returns[n];
    const double target = 0.5 * (weight_[cell] + weight_[cell - 1]);
    shares[n] = std::clamp((target - weight_[at]) / whole, 0.0, 1.0);
    at = cell;
  }
  return shares;
}

std::vector<FoundReturns> gsa_returns(const ReturnProblem& problem,
                                      const GsaReturnsSettings& settings,
                                      ReturnObjective& objective) {
  const auto simple = simple_plan(problem);
  require(simple.has_value(), "returns are searched where there are some");
  const std::size_t variables = simple->returns.size();
  if (variables == 0) return {{.returns = {}, .objective_s = objective({})}};

  const ShareCode code{problem, objective.cost()};
  Returns returns;
  GsaProblem search{
      .low = std::vector<double>(variables, least_share),
      .high = std::vector<double>(variables, 1.0),
      .objective =
          [&](std::span<const double> shares) {
            code.decode(shares, returns);
            return objective(returns);
          },
      .repair = {},
      .starts = {std::vector<double>(variables, 1.0), code.encoded(simple->returns, variables)}};
  std::vector<FoundReturns> found;
  for (std::uint32_t i = 0; i < settings.searches; ++i) {
    const GsaResult result = gsa_minimum(search, {.masses = settings.masses,
                                                  .iterations = settings.iterations,
                                                  .g0 = g0,
                                                  .alpha = alpha,
                                                  .seed = seed_for(settings.seed, {i})});
    search.starts.clear();
    code.decode(result.best, returns);
    found.push_back({.returns = returns, .objective_s = result.value});
  }
  std::stable_sort(found.begin(), found.end(), [](const FoundReturns& a, const FoundReturns& b) {
    return a.objective_s < b.objective_s;
  });
  return found;
}

}  // namespace furrow::planner
