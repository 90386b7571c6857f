#pragma once

#include "core/time.hpp"
#include "core/work.hpp"

#include <string>

namespace furrow {

/// A round obstacle that no plan knows. It stands there all the same, for aircraft to see.
struct Surprise {
  std::string id;
  SeenObstacle obstacle;
  Instant appears{};   ///< It is not there before.
  Length seen_within;  ///< Of an aircraft from its edge, > 0.
};

}  // namespace furrow
