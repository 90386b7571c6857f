#pragma once

#include "core/expected.hpp"
#include "core/field.hpp"
#include "planner/coverage/geos.hpp"
#include "planner/plan_error.hpp"

#include <optional>
#include <string>

namespace furrow::planner {

/// The land that a ring encloses, around an origin.
struct MendedRing {
  LandParts parts;
  std::optional<Defect> defect;  ///< What was wrong with the ring; nothing if it was sound.
};

/// The middle of a ring's box in whole metres, so that short decimal coordinates stay exact after
/// the shift. @pre The ring has vertices.
PointM origin_of(const Ring& ring);

/// Mends a ring: repeated vertices, spikes without width and either orientation.
///
/// @param which  Names the ring in errors: "boundary".
/// @error field_invalid  The ring has fewer than 3 vertices, is not finite, encloses no area, or
///                       encloses ground ambiguously, by more than 1e-6 of its area.
Expected<MendedRing, PlanError> mended(const Ring& ring, PointM origin, const std::string& which);

/// A field whose holes are apart, and what was done to make them so.
struct SoundField {
  struct Remark {
    std::optional<std::size_t> hole;  ///< Index of the hole concerned; otherwise the boundary.
    std::string what;                 ///< "lies outside the boundary and is left out".
    FieldPoint at;
  };
  Field field;
  std::vector<Remark> remarks;
};

/// Makes holes one where they touch or overlap, cuts them at the boundary, leaves out those beyond
/// it and land that they close in. Where none touches another or the boundary, all rings stay as
/// they are; the boundary always does, and is judged only.
///
/// @error field_invalid     As `mended` says.
/// @error nothing_to_spray  Holes cover the whole field.
Expected<SoundField, PlanError> sound_field(const Field& field);

}  // namespace furrow::planner
