#include "sim/checkers/laws.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <set>

namespace furrow::sim {
namespace {

constexpr double kept_share = 0.9;

class ClearanceLaws final : public Checker {
 public:
  explicit ClearanceLaws(const Facts& facts) {
    const auto& sweep = facts.plan.sweep;
    if (!sweep || !sweep->avoidance) return;
    for (const Obstacle& o : facts.field.obstacles) {
      if (o.outline.empty()) obstacles_.push_back({o.id, o.center, o.radius, Instant::min()});
    }
    for (const Surprise& s : facts.surprises) {
      obstacles_.push_back({s.id, s.obstacle.center, s.obstacle.radius, s.appears});
    }
    for (const auto& uav : facts.plan.uavs) {
      kept_[uav.vehicle.id] =
          std::max(Length{}, kept_share * sweep->avoidance->safety - uav.vehicle.gnss.bias);
    }
  }

  void observe(const Envelope& e) override {
    const auto* flown = std::get_if<FlightRecord>(&e.body);
    if (flown == nullptr) return;
    const auto kept = kept_.find(flown->agent);
    if (kept == kept_.end()) return;
    for (const TrackPoint& point : flown->track) {
      for (const Standing& obstacle : obstacles_) {
        if (point.at < obstacle.since) continue;
        const Length away = distance(obstacle.center, point.position) - obstacle.radius;
        if (away < kept->second) tell(flown->agent, obstacle, away, kept->second, point.at);
      }
    }
  }

  void conclude(Instant) override {}

 private:
  struct Standing {
    std::string id;
    FieldPoint center;
    Length radius;
    Instant since;
  };

  // Once for each aircraft and obstacle.
  void tell(AgentId agent, const Standing& obstacle, Length away, Length kept, Instant at) {
    if (!told_.insert({agent, obstacle.id}).second) return;
    report("L22", at,
           fmt::format("UAV {} was {:.2f} m from obstacle {}, less than {:.2f} m",
                       static_cast<std::uint32_t>(agent), away.base(), obstacle.id, kept.base()));
  }

  std::vector<Standing> obstacles_;
  std::map<AgentId, Length> kept_;
  std::set<std::pair<AgentId, std::string>> told_;
};

}  // namespace

std::unique_ptr<Checker> clearance_laws(const Facts& facts) {
  return std::make_unique<ClearanceLaws>(facts);
}

}  // namespace furrow::sim
