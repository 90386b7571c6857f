#pragma once

#include "app/results/result.hpp"

#include <string>
#include <utility>
#include <vector>

namespace furrow::app {

/// Every single figure of a result by its path in result.json ("coverage.missed_m2"), in the file's
/// order; "completed" is 0 or 1, "laws.violations" a count.
std::vector<std::pair<std::string, double>> figures(const Result& result);

/// Judges each expectation against the figures. A key is a figure's path, or its last part where
/// the first figure of that name is meant. Bounds count as inside.
std::vector<ExpectationFigures> judged(const std::vector<mission::Expectation>& expectations,
                                       const Result& result);

/// Whether every expectation is met.
bool all_met(const Result& result);

}  // namespace furrow::app
