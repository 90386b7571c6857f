#include "mission/checks.hpp"

#include "mission/polygon.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace furrow::mission {
namespace {

// A hole lies inside if one vertex does and no edge of it meets the boundary.
std::optional<std::string> hole_fault(const Ring& hole, const Ring& boundary) {
  if (!is_inside(hole.front(), boundary)) {
    return fmt::format("must lie inside the boundary: {} does not", text(hole.front()));
  }
  if (const auto touch = contact(hole, boundary)) {
    return fmt::format("must lie inside the boundary: {}", *touch);
  }
  return {};
}

std::optional<std::string> overlap(const Ring& a, const Ring& b) {
  if (auto touch = contact(a, b)) return touch;
  if (is_inside(a.front(), b)) return fmt::format("{} lies in both", text(a.front()));
  if (is_inside(b.front(), a)) return fmt::format("{} lies in both", text(b.front()));
  return {};
}

// Holes that are sound, apart from each other; the first conflict of each.
void check_apart(const Section& field, const std::vector<Ring>& holes,
                 const std::vector<bool>& sound) {
  for (std::size_t i = 0; i < holes.size(); ++i) {
    for (std::size_t j = 0; j < i && sound[i]; ++j) {
      if (!sound[j]) continue;
      if (const auto place = overlap(holes[i], holes[j])) {
        field.fail(fmt::format("holes_m[{}]", i),
                   fmt::format("must keep apart from holes_m[{}]: {}", j, *place));
        break;
      }
    }
  }
}

void check_start(const Section& field, const Scenario& s) {
  if (!s.start) return;
  const bool in_hole = std::any_of(s.field.holes.begin(), s.field.holes.end(),
                                   [&](const Ring& h) { return is_inside(*s.start, h); });
  if (!is_inside(*s.start, s.field.boundary) || in_hole) {
    field.fail("start_m", "must lie inside the boundary and outside the holes", text(*s.start));
  }
}

void check_swaths(const Draft& draft) {
  const auto& uavs = draft.scenario.uavs;
  for (std::size_t i = 1; i < uavs.size(); ++i) {
    const bool is_first_of_entry = draft.fleet_of[i] != draft.fleet_of[i - 1];
    if (is_first_of_entry && uavs[i].swath != uavs[0].swath) {
      draft.fleets[draft.fleet_of[i]].fail(
          "swath_m", fmt::format("must equal that of uavs[0], {:.10g}: one route serves all",
                                 uavs[0].swath.base()));
    }
  }
}

// Keeps a grid over the field within memory.
void check_cells(const Draft& draft) {
  if (!std::holds_alternative<planner::CoverageSettings>(draft.scenario.coverage)) return;
  constexpr double most_cells = 10e6;
  double low_x = 1e9, low_y = 1e9, high_x = -1e9, high_y = -1e9;
  for (const FieldPoint p : draft.scenario.field.boundary) {
    low_x = std::min(low_x, p.x.base());
    high_x = std::max(high_x, p.x.base());
    low_y = std::min(low_y, p.y.base());
    high_y = std::max(high_y, p.y.base());
  }
  const double swath_m = draft.scenario.uavs[0].swath.base();
  if ((high_x - low_x) * (high_y - low_y) / (swath_m * swath_m) > most_cells) {
    draft.fleets[0].fail("swath_m", fmt::format("must cut the field's {:.10g} x {:.10g} m into at "
                                                "most {:.10g} cells",
                                                high_x - low_x, high_y - low_y, most_cells));
  }
}

// Whether a UAV gets from the station to the nearest ground of the field and back on one pack.
bool reaches(const Vehicle& v, Length away) {
  return 2.0 * away / v.ferry_speed <= usable_endurance(v);
}

void check_reach(const Draft& draft) {
  const auto& s = draft.scenario;
  std::vector<Length> away;
  std::vector<bool> is_reached(s.stations.size());
  for (const auto& station : s.stations) {
    away.push_back(distance(station.position, s.field.boundary));
  }
  std::vector<bool> gets_there(draft.fleets.size());
  for (std::size_t u = 0; u < s.uavs.size(); ++u) {
    for (std::size_t k = 0; k < away.size(); ++k) {
      if (!reaches(s.uavs[u], away[k])) continue;
      is_reached[k] = true;
      gets_there[draft.fleet_of[u]] = true;
    }
  }
  for (std::size_t k = 0; k < away.size(); ++k) {
    if (is_reached[k]) continue;
    draft.stations[k].fail("position_m",
                           "must be within reach of the field: there and back on one pack",
                           fmt::format("{:.10g} m away", away[k].base()));
  }
  const bool any = std::any_of(is_reached.begin(), is_reached.end(), [](bool b) { return b; });
  for (std::size_t i = 0; any && i < gets_there.size(); ++i) {
    if (gets_there[i]) continue;
    draft.fleets[i].fail("flight_endurance_s", "must last from some station to the field and back");
  }
}

void check_faults(const Draft& draft) {
  const auto uavs = draft.scenario.uavs.size();
  for (std::size_t i = 0; i < draft.faults.size(); ++i) {
    if (number(draft.scenario.faults[i].target) <= uavs) continue;
    draft.faults[i].fail("target", fmt::format("must be the id of a UAV, 1 to {}", uavs));
  }
}

}  // namespace

void check_field(const Section& field, const Field& land) {
  if (land.boundary.empty()) return;
  const auto fault = ring_fault(land.boundary);
  if (fault) field.fail("boundary_m", *fault);
  std::vector<bool> sound;
  for (std::size_t i = 0; i < land.holes.size(); ++i) {
    const Ring& hole = land.holes[i];
    sound.push_back(!hole.empty());
    if (hole.empty()) continue;
    auto why = ring_fault(hole);
    if (!why && !fault) why = hole_fault(hole, land.boundary);
    if (why) field.fail(fmt::format("holes_m[{}]", i), *why);
    sound.back() = !why;
  }
  check_apart(field, land.holes, sound);
}

void check_together(const Section& root, const Draft& draft) {
  const bool field = draft.field_in_order, fleet = draft.fleet_in_order;
  if (field) check_start(root.section("field"), draft.scenario);
  if (fleet) check_swaths(draft);
  if (field && fleet) check_cells(draft);
  if (field && fleet && draft.supply_in_order) check_reach(draft);
  if (fleet && draft.faults_in_order) check_faults(draft);
}

}  // namespace furrow::mission
