#include "scheduler/remnant.hpp"

#include "core/require.hpp"

#include <algorithm>

namespace furrow::scheduler {
namespace {

/// `cells` of `strip`, under the numbers of the whole route, reached from nowhere.
planner::Strip cut(const planner::Route& whole, const planner::Strip& strip, CellRange cells) {
  planner::Strip left = strip;
  left.cells = cells;
  left.from = whole.centers[cells.first];
  left.to = whole.centers[end(cells) - 1];
  left.begin = planner::start_point(whole, strip, cells.first);
  left.end = planner::stop_point(whole, strip, end(cells) - 1);
  left.continues = false;
  if (cells.first > strip.cells.first) left.joins = whole.centers[cells.first - 1];
  left.approach.clear();
  left.approach_altitudes_m.clear();
  return left;
}

/// How `next` is reached from the strip before it in the remnant.
void connect(const planner::Route& whole, const planner::Strip& before, planner::Strip& next) {
  const planner::Strip& strip = whole.strips[planner::strip_of(whole, next.cells.first)];
  if (end(before.cells) == next.cells.first && strip.cells.first == next.cells.first) {
    next.continues = strip.continues;
    next.approach = strip.approach;
    next.approach_altitudes_m = strip.approach_altitudes_m;
    return;
  }
  next.approach = approach_over(whole.ferries, before, next);
}

}  // namespace

Remnant remnant(const planner::Route& whole, std::span<const CellRange> runs) {
  require(!runs.empty(), "something is left");
  Remnant left{.route = {.cell = whole.cell,
                         .centers = {},
                         .strips = {},
                         .missed = {},
                         .ferries = whole.ferries},
               .cells = {}};
  for (const CellRange run : runs) {
    for (std::uint32_t first = run.first; first < end(run);) {
      const planner::Strip& strip = whole.strips[planner::strip_of(whole, first)];
      const std::uint32_t stop = std::min(end(run), end(strip.cells));
      planner::Strip next = cut(whole, strip, {first, stop - first});
      if (!left.route.strips.empty()) connect(whole, left.route.strips.back(), next);
      left.route.strips.push_back(std::move(next));
      first = stop;
    }
  }
  for (planner::Strip& strip : left.route.strips) {
    const auto first = static_cast<std::uint32_t>(left.cells.size());
    for (std::uint32_t c = strip.cells.first; c < end(strip.cells); ++c) {
      left.cells.push_back(c);
      left.route.centers.push_back(whole.centers[c]);
      if (!whole.detours.empty()) left.route.detours.push_back(whole.detours[c]);
    }
    strip.cells.first = first;
  }
  return left;
}

std::vector<CellRange> joined(std::vector<CellRange> runs) {
  std::sort(runs.begin(), runs.end(), [](CellRange a, CellRange b) { return a.first < b.first; });
  std::vector<CellRange> all;
  for (const CellRange run : runs) {
    if (!all.empty() && end(all.back()) == run.first) {
      all.back().count += run.count;
    } else {
      all.push_back(run);
    }
  }
  return all;
}

}  // namespace furrow::scheduler
