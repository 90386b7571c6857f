#include "agents/vehicle/lookout.hpp"

#include <algorithm>
#include <utility>

namespace furrow::agents {

Lookout::Lookout(std::vector<Surprise> surprises) : unseen_{std::move(surprises)} {}

std::vector<SeenObstacle> Lookout::sees(Xy truth_m, Instant t) {
  const auto is_hidden = [&](const Surprise& s) {
    const Length away = distance(s.obstacle.center, field_point(truth_m)) - s.obstacle.radius;
    return t < s.appears || away > s.seen_within;
  };
  const auto first = std::stable_partition(unseen_.begin(), unseen_.end(), is_hidden);
  std::vector<SeenObstacle> seen;
  seen.reserve(static_cast<std::size_t>(unseen_.end() - first));
  std::transform(first, unseen_.end(), std::back_inserter(seen),
                 [](const Surprise& s) { return s.obstacle; });
  unseen_.erase(first, unseen_.end());
  return seen;
}

}  // namespace furrow::agents
