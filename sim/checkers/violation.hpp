#pragma once

#include "core/time.hpp"

#include <string>

namespace furrow::sim {

/// A law of the fleet that a run broke.
struct Violation {
  std::string law;  ///< "L1", "L2", ...
  Instant at;
  std::string detail;  ///< Who, what, with numbers and units.
};

}  // namespace furrow::sim
