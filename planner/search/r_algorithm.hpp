#pragma once
// Shor's r-algorithm: up a concave function that has slopes but no gradient everywhere.

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace furrow::planner {

/// Value at `x`, with a supergradient there written to `slope`.
using SlopedFunction = std::function<double(std::span<const double> x, std::span<double> slope)>;

struct RSettings {
  std::uint32_t evaluations;  ///< At most, >= 1.
  double step = 1.0;          ///< Of the first step, in the measure of x; > 0.
  double dilation = 3.0;      ///< > 1.
};

struct RResult {
  std::vector<double> best;
  double value;
  std::uint32_t evaluations;
};

/// The highest point passed. Steps run along the slope in a space that is stretched, after each,
/// against the difference of the last two slopes; they lengthen while they lead upwards.
///
/// Time O(evaluations x dimensions^2) besides the function's.
///
/// Source: Shor 1985, Minimization Methods for Non-Differentiable Functions, chapter 3.
RResult r_algorithm(const SlopedFunction& function, std::vector<double> start,
                    const RSettings& settings);

}  // namespace furrow::planner
