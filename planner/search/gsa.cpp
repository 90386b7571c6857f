#include "planner/search/gsa.hpp"

#include "core/random.hpp"
#include "core/require.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace furrow::planner {
namespace {

/// Positions, velocities and accelerations are mass-major arrays of N x dimensions.
class Swarm {
 public:
  Swarm(const GsaProblem& problem, const GsaSettings& settings)
      : problem_{problem},
        settings_{settings},
        n_{settings.masses},
        dimensions_{problem.low.size()},
        random_{settings.seed},
        x_(n_ * dimensions_),
        v_(n_ * dimensions_, 0.0),
        a_(n_ * dimensions_),
        fitness_(n_),
        mass_(n_),
        heaviest_(n_) {
    scatter();
    evaluate();
  }

  void iterate(std::uint32_t t) {
    weigh();
    attract(t);
    move();
    evaluate();
  }

  GsaResult result;

 private:
  std::span<double> row(std::vector<double>& values, std::size_t i) {
    return {values.data() + i * dimensions_, dimensions_};
  }

  void scatter() {
    for (std::size_t i = 0; i < n_; ++i) {
      const auto x = row(x_, i);
      for (std::size_t d = 0; d < dimensions_; ++d) {
        const double low = problem_.low[d], high = problem_.high[d];
        x[d] = i < problem_.starts.size() ? std::clamp(problem_.starts[i][d], low, high)
                                          : random_.uniform(low, high);
      }
    }
    result.value = std::numeric_limits<double>::infinity();
    result.evaluations = 0;
  }

  void evaluate() {
    for (std::size_t i = 0; i < n_; ++i) {
      const auto x = row(x_, i);
      if (problem_.repair) problem_.repair(x);
      fitness_[i] = problem_.objective(x);
      if (fitness_[i] < result.value) {
        result.value = fitness_[i];
        result.best.assign(x.begin(), x.end());
      }
    }
    result.evaluations += n_;
    result.history.push_back(result.value);
  }

  void weigh() {
    const auto [best, worst] = std::minmax_element(fitness_.begin(), fitness_.end());
    const double spread = *worst - *best, worst_value = *worst;
    for (std::size_t i = 0; i < n_; ++i) {
      mass_[i] = spread > 0.0 ? (worst_value - fitness_[i]) / spread : 1.0;
    }
    const double sum = std::accumulate(mass_.begin(), mass_.end(), 0.0);
    for (double& m : mass_) m /= sum;
    std::iota(heaviest_.begin(), heaviest_.end(), std::size_t{0});
    std::stable_sort(heaviest_.begin(), heaviest_.end(),
                     [&](std::size_t a, std::size_t b) { return fitness_[a] < fitness_[b]; });
  }

  void attract(std::uint32_t t) {
    const double done = static_cast<double>(t) / settings_.iterations;
    const double g = settings_.g0 * std::exp(-settings_.alpha * done);
    const auto k_best =
        static_cast<std::size_t>(std::lround(1.0 + (1.0 - done) * static_cast<double>(n_ - 1)));
    std::fill(a_.begin(), a_.end(), 0.0);
    for (std::size_t i = 0; i < n_; ++i) {
      for (std::size_t k = 0; k < k_best; ++k) {
        if (heaviest_[k] != i) pull(i, heaviest_[k], g);
      }
    }
  }

  void pull(std::size_t i, std::size_t j, double g) {
    const auto xi = row(x_, i), xj = row(x_, j), a = row(a_, i);
    double square = 0.0;
    for (std::size_t d = 0; d < dimensions_; ++d) square += (xj[d] - xi[d]) * (xj[d] - xi[d]);
    const double strength =
        g * mass_[j] / (std::sqrt(square) + std::numeric_limits<double>::epsilon());
    for (std::size_t d = 0; d < dimensions_; ++d) {
      a[d] += random_.uniform() * strength * (xj[d] - xi[d]);
    }
  }

  void move() {
    for (std::size_t i = 0; i < n_; ++i) {
      const auto x = row(x_, i), v = row(v_, i), a = row(a_, i);
      for (std::size_t d = 0; d < dimensions_; ++d) {
        v[d] = random_.uniform() * v[d] + a[d];
        const double moved = x[d] + v[d];
        x[d] = std::clamp(moved, problem_.low[d], problem_.high[d]);
        if (x[d] != moved) v[d] = 0.0;
      }
    }
  }

  const GsaProblem& problem_;
  const GsaSettings& settings_;
  std::size_t n_, dimensions_;
  Random random_;
  std::vector<double> x_, v_, a_, fitness_, mass_;
  std::vector<std::size_t> heaviest_;  // masses by falling weight
};

}  // namespace

GsaResult gsa_minimum(const GsaProblem& problem, const GsaSettings& settings) {
  require(!problem.low.empty() && problem.low.size() == problem.high.size(),
          "a search has at least one variable, and two bounds for each");
  require(settings.masses >= 1, "gravity needs a mass");
  for (const auto& start : problem.starts) {
    require(start.size() == problem.low.size(), "a starting position has a value per variable");
  }
  Swarm swarm{problem, settings};
  for (std::uint32_t t = 0; t < settings.iterations; ++t) swarm.iterate(t);
  return std::move(swarm.result);
}

}  // namespace furrow::planner
