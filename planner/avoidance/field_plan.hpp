#pragma once
// The door to planned avoidance: straight strips in, strips around obstacles out.

#include "core/expected.hpp"
#include "core/field.hpp"
#include "planner/avoidance/room.hpp"
#include "planner/avoidance/settings.hpp"
#include "planner/plan_error.hpp"

#include <cstdint>
#include <vector>

namespace furrow::planner {

/// `field` with none of its obstacles but those that end rows: what rows are laid on that run on
/// past all others.
///
/// @param ends_rows  See AvoidanceSettings.
Field without_led_around(Field field, const std::vector<std::size_t>& ends_rows);

/// The obstacles of `field` that rows are led around, in order.
std::vector<Obstacle> led_around(const Field& field, const std::vector<std::size_t>& ends_rows);

/// The room of a field: inside boundary, holes and what ends rows, clear of all other obstacles.
///
/// @param margin     From boundary, holes and what ends rows, >= 0.
/// @param safety     From obstacles, >= 0.
/// @param ends_rows  See AvoidanceSettings.
/// @error  As `field_land`.
Expected<Room, PlanError> room_of(const Field& field, Length margin, Length hole_buffer,
                                  Length safety, const std::vector<std::size_t>& ends_rows = {});

/// A straight strip to spray.
struct StraightStrip {
  FieldPoint from, to;
  Length width;  ///< > 0.
};

/// A part of a strip as flown. Stretches follow one another without a gap, except where two
/// sprayed ones meet: there the strip is blocked, and a ferry must join its parts.
struct Stretch {
  bool spraying;
  std::vector<FieldPoint> line;  ///< At least two places; arcs as corners of tangents.
};

struct AvoidedStrip {
  std::vector<Stretch> stretches;  ///< None where obstacles leave nothing of the strip.
};

struct AvoidanceFigures {
  std::size_t targets = 0;  ///< Obstacles that straight strips cross, counted for each strip.
  std::size_t crowds = 0;   ///< Groups of them that are passed together; of these:
  std::size_t detours = 0, closed = 0, blocked = 0;
  Length straight{}, extra{};  ///< Of all strips; of all ways around.
  /// By union of footprints, outside obstacle circles; repeated beyond what straight strips repeat.
  Area missed{}, repeated{};
  double fitness = 0;            ///< As searched, with the areas of the search.
  bool exact = false;            ///< Whether no selection of the same options is fitter.
  std::uint32_t iterations = 0;  ///< Generations for the whole field.
};

struct AvoidancePlan {
  std::vector<AvoidedStrip> strips;  ///< One for each strip given.
  AvoidanceFigures figures;
};

/// Leads strips around the obstacles of `room`.
///
/// Cost: some 0.1 ms for each target and option, and the search.
AvoidancePlan plan_avoidance(const std::vector<StraightStrip>& strips, const Room& room,
                             const AvoidanceSettings& settings);

}  // namespace furrow::planner
