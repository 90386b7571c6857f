#include "planner/coverage/swath/swath_route.hpp"

namespace furrow::planner {

Route swath_route(const SwathCoverage& coverage, Length cell) {
  const auto is_narrowed = [&](const SwathStrip& s) { return s.width < (1 - 1e-9) * cell; };
  std::vector<Strip> strips;
  for (const SwathStrip& strip : coverage.strips) {
    Strip& next = strips.emplace_back();
    next.begin = strip.from;
    next.end = strip.to;
    if (is_narrowed(strip)) next.width = strip.width;
    // Approaches hold their ends too, which the strips themselves know.
    if (strip.approach.size() > 2) {
      next.approach.assign(strip.approach.begin() + 1, strip.approach.end() - 1);
    }
  }
  return end_to_end_route(cell, std::move(strips));
}

}  // namespace furrow::planner
