#include "planner/returns/battery_bound.hpp"

#include "planner/returns/sliding_minimum.hpp"

#include <algorithm>
#include <cmath>

namespace furrow::planner {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double fuzz_s = 1e-7;  // far above the rounding of sums, far below any bucket

}  // namespace

// One backward sweep over the candidates.
class BatteryBound::Pass {
 public:
  Pass(BatteryBound& bound, const Legs& legs, const BatteryFree& free)
      : bound_{bound}, legs_{legs}, free_{free}, width_s_{bound.scope_.bucket_s} {
    const double low_s = std::min(-legs.route_s[legs.last], 0.0);
    const double high_s =
        legs.pack_s + 2.0 * *std::max_element(legs.home_s.begin(), legs.home_s.end());
    lowest_ = static_cast<std::int64_t>(std::floor(low_s / width_s_)) - 3;
    const auto highest = static_cast<std::int64_t>(std::floor(high_s / width_s_)) + 4;
    windows_.resize(static_cast<std::size_t>(highest - lowest_ + 1));
    latest_landing_s_.resize(bound.scope_.candidates.size());
    double latest = -infinite;
    for (std::size_t c = 0; c < latest_landing_s_.size(); ++c) {
      latest = std::max(latest, legs.landing_s[bound.scope_.candidates[c]]);
      latest_landing_s_[c] = latest;
    }
  }

  // Returns the number of steps done.
  std::uint64_t visit(std::size_t c) {
    const std::uint32_t i = bound_.scope_.candidates[c];
    steps_ = bound_.width_;
    if (i == legs_.last) {
      for (std::size_t k = 0; k < bound_.width_; ++k) {
        const std::int64_t b = bound_.base_[c] + static_cast<std::int64_t>(k);
        bound_.at(c, b) = fits(i, b) ? 0.0 : infinite;
      }
    } else {
      relax(c, i);
    }
    publish(c, i);
    return steps_;
  }

 private:
  bool fits(std::uint32_t i, std::int64_t bucket) const {
    return static_cast<double>(bucket) * width_s_ + legs_.landing_s[i] <= legs_.pack_s + fuzz_s;
  }

  SlidingMinimum& window(std::int64_t bucket) {
    return windows_[static_cast<std::size_t>(std::clamp<std::int64_t>(
        bucket - lowest_, 0, static_cast<std::int64_t>(windows_.size()) - 1))];
  }

  void relax(std::size_t c, std::uint32_t i) {
    const double leave_s = 2.0 * legs_.home_s[i];
    const double fresh_s = legs_.fresh_offset_s(i);
    const std::uint32_t reach = legs_.reach[i];
    const double flat_s =
        legs_.home_s[i] + legs_.fill_base_s - legs_.fill_s_per_m * legs_.spray_m[i];
    std::size_t swap_from = bound_.reach_end_[c];  // candidates from here on may earn a swap
    double swapped_s = infinite;
    for (std::size_t k = 0; k < bound_.width_; ++k) {
      const std::int64_t b = bound_.base_[c] + static_cast<std::int64_t>(k);
      if (!fits(i, b)) {
        bound_.at(c, b) = infinite;
        continue;
      }
      const double low_s = static_cast<double>(b) * width_s_ + leave_s;
      const double high_s = low_s + width_s_;
      while (swap_from > c + 1 &&
             latest_landing_s_[swap_from - 1] + high_s > legs_.pack_s - fuzz_s) {
        --swap_from;
        swapped_s = std::min(swapped_s, legs_.home_s[i] + leg_s(i, swap_from, true, fresh_s));
        ++steps_;
      }
      const auto first = static_cast<std::int64_t>(std::floor((low_s - fuzz_s) / width_s_));
      const auto last = static_cast<std::int64_t>(std::floor((high_s + fuzz_s) / width_s_));
      double kept_s = infinite;
      for (std::int64_t to = first; to <= last; ++to) {
        SlidingMinimum& ends = window(to);
        ends.drop([reach](std::uint32_t p) { return p > reach; });
        kept_s = std::min(kept_s, ends.least());
      }
      double best_s = std::min(swapped_s, flat_s + kept_s);
      best_s = std::min(best_s, dry_s(c, i, first, last));
      bound_.at(c, b) = free_.until_s[i] + best_s > bound_.scope_.cutoff_s ? infinite : best_s;
    }
  }

  // Service, spraying to candidate d with this offset, and all that follows.
  double leg_s(std::uint32_t i, std::size_t d, bool swap, double offset_s) const {
    const std::uint32_t j = bound_.scope_.candidates[d];
    return legs_.service_s(i, j, swap) + legs_.arrival_s(j) + bound_.after_s(d, offset_s);
  }

  // Legs that spray nothing need no filling, which the windows do not know.
  double dry_s(std::size_t c, std::uint32_t i, std::int64_t first, std::int64_t last) {
    double best_s = infinite;
    for (std::size_t d = c + 1; d < bound_.scope_.candidates.size(); ++d) {
      const std::uint32_t j = bound_.scope_.candidates[d];
      if (legs_.spray_m[j] > legs_.spray_m[i]) break;
      for (std::int64_t to = first; to <= last; ++to) {
        const double middle_s = (static_cast<double>(to) + 0.5) * width_s_;
        best_s = std::min(best_s, legs_.home_s[i] + leg_s(i, d, false, middle_s));
      }
    }
    return best_s;
  }

  void publish(std::size_t c, std::uint32_t i) {
    const double key_s = legs_.fill_s_per_m * legs_.spray_m[i] + legs_.arrival_s(i);
    for (std::size_t k = 0; k < bound_.width_; ++k) {
      const std::int64_t b = bound_.base_[c] + static_cast<std::int64_t>(k);
      const double value_s = bound_.at(c, b);
      if (value_s < infinite) window(b).push(i, key_s + value_s);
    }
  }

  BatteryBound& bound_;
  const Legs& legs_;
  const BatteryFree& free_;
  double width_s_;
  std::int64_t lowest_;
  std::vector<SlidingMinimum> windows_;   // by bucket: where a sortie may end, filling per metre
  std::vector<double> latest_landing_s_;  // running maximum of landing_s, so that it rises
  std::uint64_t steps_ = 0;
};

BatteryBound::BatteryBound(const Legs& legs, BoundScope scope)
    : scope_{std::move(scope)},
      width_{static_cast<std::size_t>(legs.pack_s / scope_.bucket_s) + 4} {
  const std::vector<std::uint32_t>& cells = scope_.candidates;
  std::size_t end = 0;
  const auto reach_end = [&](std::uint32_t reach) {
    while (end < cells.size() && cells[end] <= reach) ++end;
    return end;
  };
  first_reach_end_ = reach_end(legs.reach[0]);
  for (const std::uint32_t i : cells) {
    // No pack on board was fresh later than here, so its offset is at least -route_s.
    base_.push_back(static_cast<std::int64_t>(std::floor(-legs.route_s[i] / scope_.bucket_s)) - 1);
    reach_end_.push_back(reach_end(legs.reach[i]));
  }
  values_.assign(cells.size() * width_, infinite);
}

std::optional<BatteryBound> BatteryBound::compute(const Legs& legs, const BatteryFree& free,
                                                  BoundScope scope, std::uint64_t& work_left) {
  const double states = static_cast<double>(scope.candidates.size()) * legs.pack_s / scope.bucket_s;
  if (states > static_cast<double>(work_left)) return std::nullopt;
  BatteryBound bound{legs, std::move(scope)};
  Pass pass{bound, legs, free};
  for (std::size_t c = bound.scope_.candidates.size(); c-- > 0;) {
    const std::uint64_t steps = pass.visit(c);
    if (steps > work_left) {
      work_left = 0;
      return std::nullopt;
    }
    work_left -= steps;
  }
  return bound;
}

double BatteryBound::after_s(std::size_t c, double offset_s) const {
  const auto bucket = static_cast<std::int64_t>(std::floor(offset_s / scope_.bucket_s));
  const std::int64_t k = bucket - base_[c];
  if (k < 0 || k >= static_cast<std::int64_t>(width_)) return infinite;
  return values_[c * width_ + static_cast<std::size_t>(k)];
}

std::vector<std::uint32_t> BatteryBound::surviving(const BatteryFree& free, double cutoff_s) const {
  std::vector<std::uint32_t> cells;
  for (std::size_t c = 0; c < scope_.candidates.size(); ++c) {
    const double* values = values_.data() + c * width_;
    const double best_s = *std::min_element(values, values + width_);
    if (free.until_s[scope_.candidates[c]] + best_s <= cutoff_s) {
      cells.push_back(scope_.candidates[c]);
    }
  }
  return cells;
}

}  // namespace furrow::planner
