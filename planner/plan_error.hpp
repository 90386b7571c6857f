#pragma once

#include "core/geometry.hpp"

#include <optional>
#include <string>

namespace furrow::planner {

/// Why there is no plan. Each value names one thing an operator can change.
enum class PlanFault {
  field_invalid,          ///< Redraw the boundary or the holes.
  nothing_to_spray,       ///< Use a narrower swath, a smaller margin or another field.
  start_not_workable,     ///< Move the start onto a workable cell, or leave it out.
  direction_unsupported,  ///< The grid model flies along a multiple of 90 degrees.
  out_of_reach,           ///< Move the station closer or use a pack that lasts longer.
  tank_too_small,         ///< A tank must last for at least one cell.
  swaths_differ,          ///< Aircraft that share one route spray one width.
  margin_too_wide,        ///< Use a smaller margin: the field vanishes under it.
  too_many_rows,          ///< Use a wider swath, or a smaller field.
  window_too_short,       ///< Let an aircraft fly for longer, or take more of them.
  hours_too_short,        ///< Keep a station open for longer, or use other stations.
  kept_out,               ///< Move the keep-out volume, or what lies in it.
  ceiling_too_low,        ///< Raise the ceiling, or let ferries search ways past hills.
};

struct PlanError {
  PlanFault fault;
  std::string detail;  ///< The ring, cell, aircraft or station at fault, with numbers and units.
  std::optional<FieldPoint> at = {};  ///< Where the fault lies, if at one place.
};

}  // namespace furrow::planner
