#include "sim/checkers/laws.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>

namespace furrow::sim {
namespace {

constexpr double round_off = 1e-6;  // share of a pack or tank that sums of ticks may be off by

bool is_airborne(Phase phase) {
  return phase == Phase::fly_out || phase == Phase::spray || phase == Phase::hold ||
         phase == Phase::fly_back;
}

class EnergyLaws final : public Checker {
 public:
  explicit EnergyLaws(const Facts& facts) {
    for (const auto& uav : facts.plan.uavs) planned_[uav.vehicle.id] = &uav;
  }

  void observe(const Envelope& e) override {
    if (const auto* state = std::get_if<AgentState>(&e.body)) observe_state(*state, e.sent);
    if (const auto* sortie = std::get_if<SortieReport>(&e.body)) observe_sortie(*sortie, e.sent);
  }

  void conclude(Instant ended) override {
    for (const auto& [agent, account] : accounts_) {
      if (account.phase != Phase::done) continue;  // something may still be under way
      const double sprayed = account.sprayed_m / tank_range(planned_.at(agent)->vehicle).base();
      const double left = 1.0 + account.filled - sprayed;
      if (std::abs(left - account.tank) > 1e-3) {
        report("L8", ended,
               fmt::format("{} has {:.4f} of a tank left; filled and sprayed say {:.4f}",
                           text(node(agent)), account.tank, left));
      }
    }
  }

 private:
  struct Account {
    Phase phase = Phase::idle;
    double tank = 1.0, filled = 0.0, sprayed_m = 0.0;
  };

  void observe_state(const AgentState& state, Instant at) {
    const scheduler::UavPlan& uav = *planned_.at(state.agent);
    Account& account = accounts_[state.agent];
    account.phase = state.phase;
    account.tank = state.tank;
    const double reserve = uav.vehicle.battery_reserve;
    if (state.battery < reserve - round_off) {
      report("L8", at,
             fmt::format("{} has {:.4f} of a pack left, its reserve is {:.4f}",
                         text(node(state.agent)), state.battery, reserve));
    }
    if (state.tank < -round_off) {
      report("L8", at, fmt::format("{} has a tank of {:.6f}", text(node(state.agent)), state.tank));
    }
    if (!is_airborne(state.phase) || state.phase == Phase::fly_back) return;
    // In still air: the least that the way home takes.
    const double home_s =
        distance(state.position, uav.station.position).base() / uav.vehicle.ferry_speed.base();
    const double need = home_s / uav.vehicle.flight_endurance.base();
    const double fix_error = (uav.vehicle.gnss.bias.base() + 4.0 * uav.vehicle.gnss.sigma.base()) /
                             uav.vehicle.ferry_speed.base() / uav.vehicle.flight_endurance.base();
    if (state.battery + fix_error + round_off < need + reserve) {
      report("L7", at,
             fmt::format("{} goes on with {:.4f} of a pack; home and reserve take {:.4f}",
                         text(node(state.agent)), state.battery, need + reserve));
    }
  }

  void observe_sortie(const SortieReport& sortie, Instant) {
    Account& account = accounts_[sortie.agent];
    account.sprayed_m += sortie.sprayed.base();
    if (sortie.serviced) account.filled += sortie.filled;
  }

  std::map<AgentId, const scheduler::UavPlan*> planned_;
  std::map<AgentId, Account> accounts_;
};

}  // namespace

std::unique_ptr<Checker> energy_laws(const Facts& facts) {
  return std::make_unique<EnergyLaws>(facts);
}

}  // namespace furrow::sim
