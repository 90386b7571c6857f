#pragma once
// What an aircraft decides by itself when it meets an obstacle that no plan knew.

#include "core/expected.hpp"
#include "planner/avoidance/crowd.hpp"
#include "planner/avoidance/dubins.hpp"
#include "planner/avoidance/room.hpp"

#include <optional>
#include <string_view>
#include <vector>

namespace furrow::planner {

/// The straight line that is being flown, and from where.
struct OnboardLine {
  Pose pose;        ///< Of the aircraft.
  FieldPoint from;  ///< Anywhere on the line behind.
  FieldPoint to;    ///< Its end.
  Length swath;     ///< > 0.
};

struct OnboardDetour {
  std::vector<FieldPoint> way;  ///< From the aircraft to the line behind the obstacles.
  Length length;                ///< Along the arcs.
  Side side;                    ///< On which the first of them is passed.
  bool sprays = true;           ///< Whether with the valve open.
  std::size_t leaves = 0;       ///< The place of the way at which it leaves the line.
};

/// What a detour's length and the ground that it misses or sprays twice count in the choice; as of
/// AvoidanceSettings.
struct DetourWeights {
  double length = 0.5, area = 0.5;
};

/// How obstacles that no plan knew are kept away from.
struct AvoidanceRule {
  Room planned{{}, {}, {}};        ///< The land with the obstacles that the plan knew.
  Room beyond{{}, {}, {}};         ///< The same without the field's boundary.
  Length clearance{};              ///< From the edge of every other, >= 0.
  Length turn_radius = metres(1);  ///< Of detours on strips, > 0.
  DetourWeights weights{};         ///< By which they are chosen.
};

/// Why there is none.
enum class NoDetour {
  nothing_ahead,  ///< The line ahead is clear.
  too_late,       ///< Too near for a turn.
  no_room,        ///< Neither side is free, or the line ends too soon behind.
};

constexpr std::string_view name(NoDetour why) {
  switch (why) {
    case NoDetour::nothing_ahead: return "nothing_ahead";
    case NoDetour::too_late: return "too_late";
    case NoDetour::no_room: return "no_room";
  }
  return "unknown";
}

/// The way around the first obstacles ahead and back to the line: of the sides that are free, valve
/// open or closed, the one of least length and missed and repeated area, neighbours taken to be
/// straight. An aircraft beside its line or askew joins it first.
///
/// @param room         Holds the obstacles known, the new one among them, with safety distance.
/// @param turn_radius  > 0.
///
/// Cost: below 1 ms for a few obstacles.
Expected<OnboardDetour, NoDetour> onboard_detour(const OnboardLine& line, const Room& room,
                                                 Length turn_radius, DetourWeights weights = {});

/// A way point around obstacles.
struct OnboardBend {
  FieldPoint at;
  bool sprays;  ///< Whether the valve is open on the way to it.
};

/// A line with its detours, one after another.
struct OnboardWay {
  std::vector<OnboardBend> bends{};  ///< All but its ends; none where the line is clear.
  Length longer{};                   ///< Than the line.
  Length dry{};                      ///< Flown around with the valve closed.
};

/// The way from `from` to `to` around all that `room` holds, as an aircraft on that line finds it.
/// @return  Nothing where no detour fits, or the ends are one place.
std::optional<OnboardWay> onboard_way(FieldPoint from, FieldPoint to, Length swath,
                                      const Room& room, Length turn_radius,
                                      DetourWeights weights = {});

}  // namespace furrow::planner
