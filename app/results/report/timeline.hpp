#pragma once

#include "app/results/flown.hpp"
#include "app/results/result.hpp"

#include <vector>

namespace furrow::app {

/// What each UAV of a result did when, sorted by time: from heartbeats where there are any, else
/// from its sorties.
std::vector<std::vector<Span>> timelines(const Result& result, const Flown& flown);

}  // namespace furrow::app
