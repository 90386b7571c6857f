#include "planner/search/r_algorithm.hpp"

#include <cmath>
#include <cstddef>

namespace furrow::planner {
namespace {

using Vector = std::vector<double>;

double dot(const Vector& a, const Vector& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// Scales to length 1. False if there is no length.
bool normalise(Vector& v) {
  const double length = std::sqrt(dot(v, v));
  if (!(length > 1e-300)) return false;
  for (double& x : v) x /= length;
  return true;
}

/// The stretched space: from its directions to those of x.
class Space {
 public:
  explicit Space(std::size_t n) : n_{n}, rows_(n * n, 0.0) {
    for (std::size_t i = 0; i < n; ++i) rows_[i * n + i] = 1.0;
  }
  Vector seen(const Vector& slope) const {
    Vector result(n_, 0.0);
    for (std::size_t i = 0; i < n_; ++i) {
      for (std::size_t j = 0; j < n_; ++j) result[j] += rows_[i * n_ + j] * slope[i];
    }
    return result;
  }
  Vector direction(const Vector& inside) const {
    Vector result(n_);
    for (std::size_t i = 0; i < n_; ++i) {
      double sum = 0.0;
      for (std::size_t j = 0; j < n_; ++j) sum += rows_[i * n_ + j] * inside[j];
      result[i] = sum;
    }
    return result;
  }
  void stretch(const Vector& along, double factor) {
    const Vector line = direction(along);
    for (std::size_t i = 0; i < n_; ++i) {
      for (std::size_t j = 0; j < n_; ++j) rows_[i * n_ + j] += (factor - 1.0) * line[i] * along[j];
    }
  }

 private:
  std::size_t n_;
  Vector rows_;
};

}  // namespace

RResult r_algorithm(const SlopedFunction& function, std::vector<double> start,
                    const RSettings& settings) {
  constexpr std::uint32_t patience = 3;
  constexpr double longer = 1.15, shorter = 0.95;
  Vector x = std::move(start), slope(x.size()), next(x.size());
  RResult result{x, function(x, slope), 1};
  Space space{x.size()};
  double step = settings.step;
  while (result.evaluations < settings.evaluations) {
    Vector inside = space.seen(slope);
    if (!normalise(inside)) break;
    const Vector up = space.direction(inside);
    std::uint32_t steps = 0;
    do {
      for (std::size_t i = 0; i < x.size(); ++i) x[i] += step * up[i];
      const double value = function(x, next);
      ++result.evaluations;
      if (value > result.value) {
        result.value = value;
        result.best = x;
      }
      if (++steps % patience == 0) step *= longer;
    } while (dot(up, next) > 0.0 && result.evaluations < settings.evaluations);
    if (steps == 1) step *= shorter;
    Vector change(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) change[i] = next[i] - slope[i];
    change = space.seen(change);
    if (normalise(change)) space.stretch(change, 1.0 / settings.dilation);
    slope.swap(next);
  }
  return result;
}

}  // namespace furrow::planner
