#pragma once

#include "core/geometry.hpp"
#include "exchange/local_frame.hpp"

#include <optional>
#include <string>

namespace furrow::mission {

/// "(40, 700) m", and ", lat 51.7810000, lon 4.2620000" where the field frame has a place on the
/// globe.
std::string place(FieldPoint p, const std::optional<exchange::Datum>& datum);

}  // namespace furrow::mission
