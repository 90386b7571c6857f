#pragma once

#include "app/results/flown.hpp"
#include "app/results/result.hpp"

namespace furrow::app {

/// Coverage of the swath model, in true areas: from the union of footprints of the strips as
/// planned, or of the true tracks as flown.
///
/// @param cells  The ledger's view, of which unrouted, abandoned and uncertain are kept.
/// @param flown  Null when only planned.
CoverageFigures sweep_coverage(const MissionRecord& record, const CoverageFigures& cells,
                               const Flown* flown);

}  // namespace furrow::app
