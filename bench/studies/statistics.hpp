#pragma once
// What a comparison over seeds says.

#include <algorithm>
#include <cmath>
#include <vector>

namespace furrow::studies {

inline double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

inline double deviation(const std::vector<double>& values) {
  const double m = mean(values);
  double sum = 0;
  for (const double v : values) sum += (v - m) * (v - m);
  return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

inline double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return (values[(n - 1) / 2] + values[n / 2]) / 2;
}

inline double worst(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

/// Probability that two samples of one distribution differ as much in rank: Wilcoxon's rank-sum
/// test, two-sided, normal approximation with correction for ties; for samples of 10 or more.
/// Source: Mann, Whitney 1947, Ann. Math. Stat. 18(1), 50-60.
inline double rank_sum_p(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<std::pair<double, bool>> all;
  for (const double v : a) all.push_back({v, true});
  for (const double v : b) all.push_back({v, false});
  std::sort(all.begin(), all.end());
  const auto n = static_cast<double>(a.size()), m = static_cast<double>(b.size());
  double ranks_of_a = 0, ties = 0;
  for (std::size_t i = 0; i < all.size();) {
    std::size_t end = i;
    while (end < all.size() && all[end].first == all[i].first) ++end;
    const auto t = static_cast<double>(end - i);
    const double rank = static_cast<double>(i + 1 + end) / 2;
    for (; i < end; ++i) ranks_of_a += all[i].second ? rank : 0;
    ties += t * t * t - t;
  }
  const double u = ranks_of_a - n * (n + 1) / 2;
  const double variance = n * m / 12 * (n + m + 1 - ties / ((n + m) * (n + m - 1)));
  if (variance <= 0) return 1;
  return std::erfc(std::abs(u - n * m / 2) / std::sqrt(2 * variance));
}

}  // namespace furrow::studies
