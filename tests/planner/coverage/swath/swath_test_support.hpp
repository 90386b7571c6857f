#pragma once

#include "planner/coverage/swath/swath.hpp"

#include <vector>

namespace furrow::planner {

/// The planned way as tracks with the valve open on strips only; one for each part of the field.
inline std::vector<std::vector<FlownPlace>> planned_tracks(const SwathCoverage& coverage) {
  std::vector<std::vector<FlownPlace>> tracks;
  for (const SwathStrip& strip : coverage.strips) {
    if (strip.approach.empty()) tracks.emplace_back();
    for (const FieldPoint p : strip.approach) tracks.back().push_back({p, false});
    tracks.back().push_back({strip.from, false});
    tracks.back().push_back({strip.to, true});
  }
  return tracks;
}

/// Metres of the planned way over no land of `field`; negative if the field is refused.
inline double outside_m(const Field& field, Length swath, const SwathCoverage& coverage) {
  const auto flown = flown_coverage(field, swath, planned_tracks(coverage));
  return flown ? flown->outside.base() : -1;
}

inline double covered_share(const SwathCoverage& c) {
  return c.areas.covered / (c.areas.covered + c.areas.missed);
}

}  // namespace furrow::planner
