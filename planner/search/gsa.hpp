#pragma once
// The gravitational search algorithm: points of a box as masses that attract one another, the
// better the heavier. Knows nothing of spraying.

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace furrow::planner {

/// What is minimised. Called with one value per variable, within the bounds; must be finite.
using GsaObjective = std::function<double(std::span<const double>)>;

/// Rewrites a point into an equivalent or admissible one before it is evaluated.
using GsaRepair = std::function<void(std::span<double>)>;

struct GsaProblem {
  std::vector<double> low, high;  ///< Bounds of each variable, low <= high; at least one variable.
  GsaObjective objective;
  GsaRepair repair = {};  ///< Left out: points stay as gravity moves them.
  /// First positions of the first masses, clamped to the bounds; the others start uniformly at
  /// random.
  std::vector<std::vector<double>> starts = {};
};

struct GsaSettings {
  std::uint32_t masses = 50;       ///< N, >= 1.
  std::uint32_t iterations = 300;  ///< T.
  double g0 = 100.0;               ///< G at the start, > 0; scales with the width of the box.
  double alpha = 20.0;             ///< Decay: G(t) = G0 exp(-alpha t / T).
  std::uint64_t seed = 0;
};

struct GsaResult {
  std::vector<double> best;
  double value;
  std::uint64_t evaluations;    ///< N (T + 1).
  std::vector<double> history;  ///< Best value at the start and after each iteration; T + 1.
};

/// The best point that the masses pass. In each iteration, for mass i and dimension d:
///
///     a_i = sum over the Kbest heaviest j != i of rand G(t) M_j (x_j - x_i) / (R_ij + eps)
///     v_i <- rand v_i + a_i,   x_i <- x_i + v_i
///
/// with M_j the normalised fitness, R_ij the Euclidean distance, rand uniform in [0, 1) and drawn
/// anew for every use, and Kbest falling linearly from N to 1. A mass that would leave the box
/// stops at its wall.
///
/// Time O(T N^2 dimensions) and N (T + 1) evaluations.
///
/// Source: Rashedi, Nezamabadi-pour, Saryazdi 2009, equations (7)-(21).
GsaResult gsa_minimum(const GsaProblem& problem, const GsaSettings& settings);

}  // namespace furrow::planner
