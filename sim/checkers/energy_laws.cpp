#include "agents/vehicle/airframe.hpp"
#include "sim/checkers/laws.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <set>

namespace furrow::sim {
namespace {

constexpr double round_off = 1e-6;    // share of a pack or tank that sums of ticks may be off by
constexpr double tank_debt_m = 2e-3;  // a tank filled to the very metre may be off by rounding
constexpr double heartbeat_s = 1.1;   // what is known of an aircraft may be so old

// Time for a straight way at ferry speed, as far as the mean wind lets an aircraft fly it.
double way_s(const Vehicle& vehicle, const Wind& wind, FieldPoint from, FieldPoint to) {
  const double length_m = distance(from, to).base();
  if (length_m == 0.0) return 0.0;
  const double from_rad = wind.from_deg * std::numbers::pi / 180.0;
  const FieldVector way = to - from;
  const double towards =
      (way.x.base() * std::sin(from_rad) + way.y.base() * std::cos(from_rad)) / length_m;
  const double headway = agents::headway_mps(vehicle, towards * wind.mean.base());
  return headway > 0.0 ? length_m / headway : std::numeric_limits<double>::infinity();
}

class EnergyLaws final : public Checker {
 public:
  explicit EnergyLaws(const Facts& facts)
      : facts_{facts}, cell_m_{planner::cell_lengths_m(facts.plan.route)} {
    for (const auto& uav : facts.plan.uavs) planned_[uav.vehicle.id] = &uav;
  }

  void observe(const Envelope& e) override {
    if (const auto* state = std::get_if<AgentState>(&e.body)) observe_state(*state, e.sent);
    if (const auto* sortie = std::get_if<SortieReport>(&e.body)) observe_sortie(*sortie, e.sent);
    if (const auto* flown = std::get_if<FlightRecord>(&e.body)) observe_flight(*flown);
    if (const auto* grant = std::get_if<WorkGrant>(&e.body)) observe_grant(*grant);
    if (const auto* claim = std::get_if<ServiceClaim>(&e.body)) observe_claim(*claim);
    if (const auto* command = std::get_if<Command>(&e.body)) observe_command(*command);
  }

  void conclude(Instant ended) override {
    for (const auto& [agent, account] : accounts_) {
      const auto planned = planned_.find(agent);
      if (planned == planned_.end() || !account.is_heard) continue;
      balance(planned->second->vehicle, account, ended);
    }
  }

 private:
  struct TakeOff {
    Instant at;
    FieldPoint position;
    double battery;
  };
  struct Account {
    bool is_heard = false;
    Phase phase = Phase::idle;
    double tank = 1.0, filled = 0.0, sprayed_m = 0.0;
    double unreported_m = 0.0;  // cells passed since the last sortie reported
    std::uint32_t unreported_runs = 0;
    std::uint64_t last_grant = 0;
    std::uint32_t sorties = 0;        // reported
    std::set<std::uint32_t> unflown;  // cells granted, of which no flight is recorded
    std::optional<TakeOff> take_off;
    std::vector<StationId> landings;      // of the sorties commanded
    std::optional<FieldPoint> bound_for;  // where the sortie under way is to end
    std::optional<FieldPoint> elsewhere;  // the last station it came to that was not that
  };

  // Mix in = mix sprayed + mix left. Of a sortie not reported yet only its cells are known: with
  // the tolerance that the dose of a sortie has, and while in the air without what was sprayed of
  // the windows it holds since the last record.
  void balance(const Vehicle& vehicle, const Account& account, Instant ended) {
    const double range_m = tank_range(vehicle).base();
    const double left_m =
        (1.0 + account.filled) * range_m - account.sprayed_m - account.unreported_m;
    double slack_m = 1e-3 * range_m, unrecorded_m = 0.0;
    if (account.unreported_m > 0.0 || is_airborne(account.phase)) {
      const double cell_m = facts_.plan.route.cell.base();
      slack_m += 0.02 * account.unreported_m + (2.0 + 0.5 * account.unreported_runs) * cell_m +
                 heartbeat_s * vehicle.spray_speed.base();
    }
    if (is_airborne(account.phase)) {
      for (const std::uint32_t cell : account.unflown) unrecorded_m += cell_m_[cell];
    }
    const double tank_m = account.tank * range_m;
    if (tank_m <= left_m + slack_m && tank_m >= left_m - slack_m - unrecorded_m) return;
    report("L8", ended,
           fmt::format("{} has {:.4f} of a tank left; filled and sprayed say {:.4f}",
                       text(node(vehicle.id)), account.tank, left_m / range_m));
  }

  void observe_state(const AgentState& state, Instant at) {
    const auto planned = planned_.find(state.agent);
    if (planned == planned_.end()) return;
    const scheduler::UavPlan& uav = *planned->second;
    Account& account = accounts_[state.agent];
    if (!is_airborne(account.phase) && is_airborne(state.phase)) {
      account.take_off = {at, state.position, state.battery};
      if (state.sortie < account.landings.size()) {
        account.bound_for = position_of(account.landings[state.sortie]);
      }
    }
    account.is_heard = true;
    account.phase = state.phase;
    account.tank = state.tank;
    const double reserve = uav.vehicle.battery_reserve;
    if (state.battery < reserve - round_off) {
      report("L8", at,
             fmt::format("{} has {:.4f} of a pack left, its reserve is {:.4f}",
                         text(node(state.agent)), state.battery, reserve));
    }
    if (state.tank < -round_off - tank_debt_m / tank_range(uav.vehicle).base()) {
      report("L8", at, fmt::format("{} has a tank of {:.6f}", text(node(state.agent)), state.tank));
    }
    if (!is_airborne(state.phase) || state.phase == Phase::fly_back) return;
    const double home_s = way_s(uav.vehicle, facts_.wind, state.position,
                                home_of(account, uav.station.position, state.position));
    const double need = home_s / uav.vehicle.flight_endurance.base();
    if (state.battery + fix_error(uav.vehicle) + round_off < need + reserve) {
      report("L7", at,
             fmt::format("{} goes on with {:.4f} of a pack; home and reserve take {:.4f}",
                         text(node(state.agent)), state.battery, need + reserve));
    }
  }

  // Share of a pack that the way home may seem longer than it is.
  static double fix_error(const Vehicle& v) {
    return (v.gnss.bias.base() + 4.0 * v.gnss.sigma.base()) / v.ferry_speed.base() /
           v.flight_endurance.base();
  }

  void observe_sortie(const SortieReport& sortie, Instant) {
    Account& account = accounts_[sortie.agent];
    if (sortie.serviced) {
      account.filled += sortie.filled;
      account.tank = std::min(1.0, account.tank + sortie.filled);  // until the next heartbeat
    }
    if (sortie.sortie < account.sorties) return;  // told again with its service
    account.sorties = sortie.sortie + 1;
    account.sprayed_m += sortie.sprayed.base();
    account.unreported_m = 0.0;
    account.unreported_runs = 0;
    judge_take_off(sortie, account);
    account.take_off.reset();
  }

  // Nobody takes off who cannot reach his first cell and come home from there.
  void judge_take_off(const SortieReport& sortie, const Account& account) {
    const auto planned = planned_.find(sortie.agent);
    if (planned == planned_.end() || !account.take_off) return;
    const auto& [at, position, battery] = *account.take_off;
    if (at < sortie.began || at > sortie.landed) return;
    const Vehicle& v = planned->second->vehicle;
    const double out_s = way_s(v, facts_.wind, position, sortie.resumed_at);
    const FieldPoint home = home_of(account, planned->second->station.position, sortie.resumed_at);
    const double home_s = way_s(v, facts_.wind, sortie.resumed_at, home);
    const double need = (out_s + home_s) / v.flight_endurance.base() + v.battery_reserve;
    if (battery + fix_error(v) + round_off >= need) return;
    report("L7", at,
           fmt::format("{} took off for sortie {} with {:.4f} of a pack; out, home and reserve "
                       "take {:.4f}",
                       text(node(sortie.agent)), sortie.sortie + 1, battery, need));
  }

  void observe_flight(const FlightRecord& flown) {
    Account& account = accounts_[flown.agent];
    account.unreported_runs += flown.cells.count > 0;
    for (std::uint32_t i = 0; i < flown.cells.count; ++i) {
      const std::uint32_t cell = flown.cells.first + i;
      if (cell >= cell_m_.size()) return;
      account.unreported_m += cell_m_[cell];
      account.unflown.erase(cell);
    }
  }

  std::optional<FieldPoint> position_of(StationId id) const {
    for (const Station& station : facts_.stations) {
      if (station.id == id) return station.position;
    }
    return std::nullopt;
  }

  // Where a sortie can end: where it is to, or where the aircraft went when its station refused it.
  static FieldPoint home_of(const Account& account, FieldPoint planned, FieldPoint from) {
    const FieldPoint home = account.bound_for.value_or(planned);
    if (!account.elsewhere) return home;
    return distance(from, *account.elsewhere) < distance(from, home) ? *account.elsewhere : home;
  }

  void observe_claim(const ServiceClaim& claim) {
    Account& account = accounts_[claim.agent];
    const auto at = position_of(claim.station);
    if (at && !(account.bound_for == at)) account.elsewhere = at;
  }

  void observe_command(const Command& command) {
    std::vector<StationId>& landings = accounts_[command.agent].landings;
    landings.clear();
    for (const SortieOrder& sortie : command.sorties) landings.push_back(sortie.station);
  }

  void observe_grant(const WorkGrant& grant) {
    Account& account = accounts_[grant.agent];
    for (const GrantWindow& window : grant.windows) {
      if (window.id <= account.last_grant) continue;
      account.last_grant = window.id;
      for (std::uint32_t i = 0; i < window.cells.count; ++i) {
        const std::uint32_t cell = window.cells.first + i;
        if (cell >= cell_m_.size()) break;
        account.unflown.insert(cell);
      }
    }
  }

  const Facts& facts_;
  std::vector<double> cell_m_;  // sprayed per cell
  std::map<AgentId, const scheduler::UavPlan*> planned_;
  std::map<AgentId, Account> accounts_;
};

}  // namespace

std::unique_ptr<Checker> energy_laws(const Facts& facts) {
  return std::make_unique<EnergyLaws>(facts);
}

}  // namespace furrow::sim
