#include "scheduler/partition.hpp"

#include <algorithm>
#include <optional>

namespace furrow::scheduler {
namespace {

constexpr double tolerance_s = 0.05;

/// Those of the aircraft's stations that are worth trying for strips from `first` on.
std::vector<std::uint32_t> stations_of(const PartitionProblem& p, std::size_t uav,
                                       std::uint32_t first) {
  if (p.paces[uav].size() == 1) return {0};
  return near_stations(p.lengths, p.route.strips[first].cells.first);
}

/// All the strips from `first` on that the aircraft can spray by `finish_s`, from its best station.
Share longest_share(const PartitionProblem& p, std::size_t uav, std::uint32_t first,
                    double finish_s) {
  const double ready_s = p.ready_s.empty() ? 0.0 : p.ready_s[uav];
  Share best{.strips = {first, 0}, .station = 0, .finish_s = 0.0};
  if (first == p.route.strips.size()) return best;
  for (const std::uint32_t s : stations_of(p, uav, first)) {
    Share share{.strips = {first, 0}, .station = s, .finish_s = 0.0};
    GrowingShare growing{p.route, p.lengths, p.paces[uav][s], first};
    while (growing.can_grow()) {
      const double grown_s = ready_s + p.stretch[uav] * growing.grow();
      if (grown_s > finish_s) break;
      ++share.strips.count;
      share.finish_s = grown_s;
    }
    const bool reaches_further = share.strips.count > best.strips.count;
    const bool is_earlier =
        share.strips.count == best.strips.count && share.finish_s < best.finish_s;
    if (reaches_further || is_earlier) best = share;
  }
  return best;
}

/// Shares that are all done by `finish_s`, if there are any.
std::optional<std::vector<Share>> shares_by(const PartitionProblem& p, double finish_s) {
  std::vector<Share> shares;
  std::uint32_t next = 0;
  for (std::size_t uav = 0; uav < p.paces.size(); ++uav) {
    shares.push_back(longest_share(p, uav, next, finish_s));
    next = end(shares.back().strips);
  }
  if (next < p.route.strips.size()) return std::nullopt;
  return shares;
}

double latest_s(const std::vector<Share>& shares) {
  double latest = 0.0;
  for (const Share& s : shares) latest = std::max(latest, s.finish_s);
  return latest;
}

}  // namespace

std::vector<Share> partition(const PartitionProblem& problem) {
  // What all aircraft need together if they never had to return, shared among them.
  double low_s = 0.0, mps = 0.0;
  for (const auto& paces : problem.paces) mps += paces[0].spray_mps;
  low_s = problem.lengths.spray_m.back() / mps;
  double high_s = std::max(low_s, 1.0);
  auto best = shares_by(problem, high_s);
  for (; !best; best = shares_by(problem, high_s)) {
    low_s = high_s;
    high_s *= 1.25;
  }
  high_s = latest_s(*best);
  while (high_s - low_s > tolerance_s) {
    const double middle_s = 0.5 * (low_s + high_s);
    if (auto shares = shares_by(problem, middle_s)) {
      best = std::move(shares);
      high_s = std::min(middle_s, latest_s(*best));
    } else {
      low_s = middle_s;
    }
  }
  return *best;
}

CellRange cells_of(const planner::Route& route, CellRange strips) {
  if (strips.count == 0) return {0, 0};
  const std::uint32_t first = route.strips[strips.first].cells.first;
  return {first, end(route.strips[end(strips) - 1].cells) - first};
}

}  // namespace furrow::scheduler
