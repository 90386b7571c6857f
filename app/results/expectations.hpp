#pragma once

#include "app/results/result.hpp"

#include <vector>

namespace furrow::app {

/// Judges each expectation against the figure of that name. Bounds count as inside; a figure that
/// the mission does not have, as the gap of one that is not completed, meets nothing.
std::vector<ExpectationFigures> judged(const std::vector<mission::Expectation>& expectations,
                                       const Result& result);

/// Whether every expectation is met.
bool all_met(const Result& result);

}  // namespace furrow::app
