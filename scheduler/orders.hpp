#pragma once

#include "scheduler/fleet_plan.hpp"

#include <vector>

namespace furrow::scheduler {

/// The plan of one aircraft as it is commanded: each sortie cut into one piece per strip. A piece
/// continues sprayed ground where its strip was entered by an earlier cell of the share: within the
/// strip, or by the sprayed move from the strip before; also where its strip is the rest of one
/// that another sprays. A sortie's first piece is flown to straight, the others by their strip's
/// approach.
///
/// @return  One order per sortie, together every cell of the share once, in order; empty for an
///          empty share.
std::vector<SortieOrder> orders(const planner::Route& route, const UavPlan& uav);

/// The pieces of all sorties, in order.
std::vector<Piece> pieces(const std::vector<SortieOrder>& sorties);

}  // namespace furrow::scheduler
