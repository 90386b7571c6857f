#include "sim/checkers/laws.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace furrow::sim {
namespace {

// Whether `p` is inside of `ring` by more than `slack`.
bool is_deep_inside(const Ring& ring, FieldPoint p, Length slack) {
  return contains(ring, p) && edge_distance(ring, p) > slack;
}

bool is_outside(const Ring& ring, FieldPoint p, Length slack) {
  return !contains(ring, p) && edge_distance(ring, p) > slack;
}

// What nobody may spray at `p`, as words, or nothing.
std::string forbidden(const Field& field, FieldPoint p, Length slack) {
  if (is_outside(field.boundary, p, slack)) return "outside the field";
  for (const Ring& hole : field.holes) {
    if (is_deep_inside(hole, p, slack)) return "inside a hole";
  }
  for (const Obstacle& obstacle : field.obstacles) {
    if (depth_in(obstacle, p) > slack) return "inside obstacle " + obstacle.id;
  }
  return {};
}

class WorkLaws final : public Checker {
 public:
  explicit WorkLaws(const Facts& facts)
      : facts_{facts},
        cell_m_{planner::cell_lengths_m(facts.plan.route)},
        sprayed_(facts.plan.route.centers.size()),
        booked_(facts.plan.route.centers.size()) {
    for (const auto& uav : facts.plan.uavs) vehicles_[uav.vehicle.id] = uav.vehicle;
  }

  void observe(const Envelope& e) override {
    if (const auto* grant = std::get_if<WorkGrant>(&e.body)) observe_grant(*grant, e.sent);
    if (const auto* flown = std::get_if<FlightRecord>(&e.body)) observe_flight(*flown, e.sent);
    if (const auto* report = std::get_if<WorkReport>(&e.body)) observe_report(*report, e.sent);
    if (const auto* sortie = std::get_if<SortieReport>(&e.body)) observe_sortie(*sortie, e.sent);
    if (const auto* state = std::get_if<SchedulerState>(&e.body)) observe_state(*state, e.sent);
    if (const auto* state = std::get_if<AgentState>(&e.body)) observe_phase(*state, e.sent);
  }

  void conclude(Instant ended) override {
    check_valves();
    if (!facts_.whole) return;
    const auto booked = static_cast<std::uint32_t>(
        std::count_if(booked_.begin(), booked_.end(), [](int n) { return n > 0; }));
    if (last_state_.open_cells != 0) {
      report("L2", ended,
             fmt::format("{} cells are neither sprayed nor reported", last_state_.open_cells));
    }
    const std::uint32_t accounted = last_state_.sprayed_cells + last_state_.abandoned_cells;
    if (accounted != booked_.size()) {
      report("L2", ended,
             fmt::format("{} cells are accounted for, of {}", accounted, booked_.size()));
    }
    std::uint32_t unheard = 0;
    for (const AgentId agent : flies_on_) unheard += work_[agent].booked;
    if (last_state_.sprayed_cells > booked || last_state_.sprayed_cells + unheard < booked) {
      report("L2", ended,
             fmt::format("the ledger says {} cells sprayed, the closures {}",
                         last_state_.sprayed_cells, booked));
    }
  }

 private:
  struct Work {
    std::map<std::uint64_t, CellRange> granted;     // by grant id
    std::map<std::uint64_t, std::uint32_t> closed;  // cells sprayed, by grant id
    std::uint32_t booked = 0;                       // the sum of these
    double sortie_m = 0.0;            // cells passed with the valve open in this sortie
    std::uint32_t sortie_pieces = 0;  // straight runs of them
    std::uint32_t sorties = 0;        // reported
    double detours_m = 0.0;           // in this sortie, at most
  };

  void observe_grant(const WorkGrant& grant, Instant at) {
    Work& work = work_[grant.agent];
    for (const GrantWindow& window : grant.windows) {
      const auto [known, is_new] = work.granted.emplace(window.id, window.cells);
      if (!is_new && !(known->second == window.cells)) {
        report("L6", at,
               fmt::format("grant {} of {} changed its cells", window.id, text(node(grant.agent))));
      }
      if (is_new && window.id != work.granted.rbegin()->first) {
        report("L6", at,
               fmt::format("grant {} of {} is not newer than the last", window.id,
                           text(node(grant.agent))));
      }
    }
  }

  void observe_flight(const FlightRecord& flown, Instant at) {
    Work& work = work_[flown.agent];
    work.sortie_pieces += flown.cells.count > 0;
    for (std::uint32_t cell = flown.cells.first; cell < end(flown.cells); ++cell) {
      if (cell >= sprayed_.size()) {
        report("L5", at,
               fmt::format("{} sprayed cell {}, which is no cell of the field",
                           text(node(flown.agent)), cell));
        return;
      }
      work.sortie_m += cell_m_[cell];
      if (++sprayed_[cell] > 1) {
        report("L1", at, fmt::format("{} sprayed cell {} again", text(node(flown.agent)), cell));
      }
      const bool is_granted =
          std::any_of(work.granted.begin(), work.granted.end(), [&](const auto& grant) {
            return cell >= grant.second.first && cell < furrow::end(grant.second);
          });
      if (!is_granted) {
        report("L6", at,
               fmt::format("{} sprayed cell {} without a grant", text(node(flown.agent)), cell));
      }
    }
    work.detours_m += detours_m(flown);
    observe_track(flown);
  }

  // The most that ways around obstacles met in flight add to what was sprayed, valve open: half
  // circles through the turn circles, (pi - 2) (R_z + R), for each obstacle passed; or take from
  // it, valve closed: 2 (R_z + R). Turn circles are within a swath.
  double detours_m(const FlightRecord& flown) const {
    const auto known = vehicles_.find(flown.agent);
    if (known == vehicles_.end()) return 0.0;
    const Length swath = known->second.swath;
    const Length turn = std::max(swath, 1.25 * known->second.min_turn_radius);
    double sum_m = 0.0;
    for (const Surprise& s : facts_.surprises) {
      const Length around = s.obstacle.radius + facts_.plan.safety + turn;
      const bool passes = std::any_of(flown.track.begin(), flown.track.end(), [&](const auto& p) {
        return p.spraying && distance(p.position, s.obstacle.center) < around + swath;
      });
      if (passes) sum_m += 2.0 * around.base();
    }
    return sum_m;
  }

  // Half a swath and what the fix may be off by: nobody can steer closer than he sees.
  void observe_track(const FlightRecord& flown) {
    const auto known = vehicles_.find(flown.agent);
    if (known == vehicles_.end()) return;
    const Vehicle& vehicle = known->second;
    const Length slack = 0.5 * vehicle.swath + vehicle.gnss.bias + 4.0 * vehicle.gnss.sigma;
    bool& was_open = was_open_.emplace(flown.agent, true).first->second;
    for (const TrackPoint& point : flown.track) {
      const bool opens = !std::exchange(was_open, point.spraying);
      if (!point.spraying) continue;
      if (!opens) open_valves_.insert({flown.agent, point.at});
      const std::string where = forbidden(facts_.field, point.position, slack);
      if (where.empty()) continue;
      report("L5", point.at,
             fmt::format("{} sprayed at ({:.1f}, {:.1f}) m, more than {:.2f} m {}",
                         text(node(flown.agent)), point.position.x.base(), point.position.y.base(),
                         slack.base(), where));
    }
  }

  // The dead have been silent for as long as their lease when they are taken for lost.
  void observe_state(const SchedulerState& state, Instant at) {
    last_state_ = state;
    for (const AgentId agent : state.lost) {
      const auto said = said_.find(agent);
      if (said != said_.end() && at - said->second < facts_.claim_lease) flies_on_.insert(agent);
    }
  }

  // A record of the flight comes after the heartbeat, so both are compared at the end. A valve that
  // opens at the very instant of a heartbeat may do so by a message that came after it.
  void observe_phase(const AgentState& state, Instant at) {
    if (state.phase != Phase::offline) said_[state.agent] = at;
    if (state.phase != Phase::spray) closed_valves_.insert({state.agent, at});
  }

  void check_valves() {
    for (const auto& [agent, at] : open_valves_) {
      if (!closed_valves_.contains({agent, at})) continue;
      report("L5", at,
             fmt::format("{} has its valve open while it does not spray", text(node(agent))));
    }
  }

  void observe_report(const WorkReport& reported, Instant at) {
    Work& work = work_[reported.agent];
    for (const Closure& closure : reported.closures) {
      const auto grant = work.granted.find(closure.grant);
      if (grant == work.granted.end() || !(grant->second == closure.cells) ||
          closure.sprayed > closure.cells.count) {
        report("L6", at,
               fmt::format("{} closed grant {}, which it does not hold so",
                           text(node(reported.agent)), closure.grant));
        continue;
      }
      const auto [known, is_new] = work.closed.emplace(closure.grant, closure.sprayed);
      if (!is_new && known->second != closure.sprayed) {
        report(
            "L1", at,
            fmt::format("{} closed grant {} twice, with {} and {} cells",
                        text(node(reported.agent)), closure.grant, known->second, closure.sprayed));
      }
      if (!is_new) continue;
      if (closure.cells.first > booked_.size() ||
          closure.sprayed > booked_.size() - closure.cells.first) {
        report("L6", at,
               fmt::format("{} closed grant {} of cells that are none of the field",
                           text(node(reported.agent)), closure.grant));
        continue;
      }
      work.booked += closure.sprayed;
      for (std::uint32_t i = 0; i < closure.sprayed; ++i) {
        if (++booked_[closure.cells.first + i] > 1) {
          report("L1", at,
                 fmt::format("cell {} is reported sprayed twice", closure.cells.first + i));
        }
      }
    }
  }

  // Dose: what left the tank, as distance sprayed, against the cells it covered. A sortie may end
  // or begin within a cell, and the smoothed turn between two strips, two quarter circles of half a
  // cell's radius, is 2 - pi / 2 = 0.43 of a cell shorter than the corners it cuts.
  void observe_sortie(const SortieReport& sortie, Instant at) {
    Work& work = work_[sortie.agent];
    if (sortie.sortie < work.sorties) return;  // told again with its service
    work.sorties = sortie.sortie + 1;
    const double cell_m = facts_.plan.route.cell.base();
    const double covered_m = work.sortie_m;
    const double slack_m =
        0.02 * covered_m + (2.0 + 0.5 * work.sortie_pieces) * cell_m + work.detours_m;
    work.detours_m = 0.0;
    work.sortie_m = 0.0;
    work.sortie_pieces = 0;
    if (std::abs(sortie.sprayed.base() - covered_m) > slack_m) {
      report("L5", at,
             fmt::format("{} sprayed {:.1f} m in sortie {} on {:.1f} m of cells",
                         text(node(sortie.agent)), sortie.sprayed.base(), sortie.sortie + 1,
                         covered_m));
    }
  }

  const Facts& facts_;
  std::map<AgentId, Vehicle> vehicles_;
  std::vector<double> cell_m_;  // sprayed per cell
  std::map<AgentId, Work> work_;
  std::vector<int> sprayed_, booked_;  // how often, by cell: in truth, and as closed
  std::map<AgentId, bool> was_open_;   // at the last point of its track
  std::set<std::pair<AgentId, Instant>> open_valves_, closed_valves_;  // by whom and when
  std::map<AgentId, Instant> said_;  // when it last said where it is, but for those who leave
  std::set<AgentId> flies_on_;       // lost and still there: what they close nobody listens to
  SchedulerState last_state_{};
};

}  // namespace

std::unique_ptr<Checker> work_laws(const Facts& facts) { return std::make_unique<WorkLaws>(facts); }

}  // namespace furrow::sim
