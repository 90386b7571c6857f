#pragma once

#include "planner/returns/legs.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace furrow::planner {

/// What a bound is computed for: plans better than `cutoff_s` that return at `candidates` only.
struct BoundScope {
  double bucket_s;                        ///< Width of the buckets that charge is rounded into.
  std::vector<std::uint32_t> candidates;  ///< Rising; the last cell included, cell 0 not.
  double cutoff_s;
};

/// Lower bounds on the non-spray time still to come, by cell and charge used.
///
/// A state-space relaxation: charge is known only to a bucket, and the best charge within the
/// bucket is assumed at every step, both for carrying a sortie and for earning a swap. Swaps are
/// forced as in `evaluated`.
/// Source: Christofides, Mingozzi, Toth 1981 (state-space relaxation).
class BatteryBound {
 public:
  /// Nothing if more than `work_left` steps would be needed; takes what it did off `work_left`.
  static std::optional<BatteryBound> compute(const Legs& legs, const BatteryFree& free,
                                             BoundScope scope, std::uint64_t& work_left);

  /// From landing at candidate number `c` with this offset (see Legs) to the end; infinite if no
  /// plan through here beats the cutoff.
  double after_s(std::size_t c, double offset_s) const;

  /// The candidates that a plan of at most `cutoff_s` may return at.
  std::vector<std::uint32_t> surviving(const BatteryFree& free, double cutoff_s) const;

  const std::vector<std::uint32_t>& candidates() const { return scope_.candidates; }
  double bucket_s() const { return scope_.bucket_s; }

  /// The candidates c + 1 .. that one tank reaches end before this number.
  std::size_t reach_end(std::size_t c) const { return reach_end_[c]; }
  std::size_t first_reach_end() const { return first_reach_end_; }

 private:
  class Pass;
  BatteryBound(const Legs& legs, BoundScope scope);

  double& at(std::size_t c, std::int64_t bucket) {
    return values_[c * width_ + static_cast<std::size_t>(bucket - base_[c])];
  }

  BoundScope scope_;
  std::size_t width_;               // buckets kept per candidate
  std::vector<std::int64_t> base_;  // the lowest bucket kept
  std::vector<double> values_;      // candidate-major
  std::vector<std::size_t> reach_end_;
  std::size_t first_reach_end_;
};

}  // namespace furrow::planner
