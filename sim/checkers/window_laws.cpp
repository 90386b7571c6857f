#include "sim/checkers/laws.hpp"

#include <fmt/format.h>
#include <map>
#include <set>

namespace furrow::sim {
namespace {

class WindowLaws final : public Checker {
 public:
  explicit WindowLaws(const Facts& facts) {
    for (const auto& uav : facts.plan.uavs) vehicles_.emplace(uav.vehicle.id, uav.vehicle);
  }

  void observe(const Envelope& e) override {
    const auto* state = std::get_if<AgentState>(&e.body);
    if (state == nullptr || !is_airborne(state->phase)) return;
    const auto known = vehicles_.find(state->agent);
    if (known == vehicles_.end()) return;
    const Vehicle& vehicle = known->second;
    const Seconds at = seconds(e.sent.time_since_epoch());
    const bool is_early = at < vehicle.available_from;
    const bool is_late = vehicle.available_until && at > *vehicle.available_until;
    if (!(is_early || is_late) || !told_.insert(state->agent).second) return;
    report("L26", e.sent,
           fmt::format("{} is in the air at {:.1f} s, {} its window", text(node(state->agent)),
                       at.base(), is_early ? "before" : "after"));
  }

  void conclude(Instant) override {}

 private:
  std::map<AgentId, Vehicle> vehicles_{};
  std::set<AgentId> told_{};
};

}  // namespace

std::unique_ptr<Checker> window_laws(const Facts& facts) {
  return std::make_unique<WindowLaws>(facts);
}

}  // namespace furrow::sim
