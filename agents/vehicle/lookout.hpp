#pragma once

#include "agents/xy.hpp"
#include "core/surprise.hpp"

#include <vector>

namespace furrow::agents {

/// A simulated sensor that measures obstacles within its range, without error.
class Lookout {
 public:
  explicit Lookout(std::vector<Surprise> surprises);

  /// What comes into sight at `truth_m` at time `t`, each obstacle once.
  std::vector<SeenObstacle> sees(Xy truth_m, Instant t);

 private:
  std::vector<Surprise> unseen_;
};

}  // namespace furrow::agents
