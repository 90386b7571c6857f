#include "sim/checkers/clearance.hpp"
#include "sim/checkers/laws.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <optional>
#include <set>

namespace furrow::sim {
namespace {

constexpr double kept_share = 0.9;
constexpr Length rtk_sigma = metres(0.02);

// Nine tenths of the safety distance, less what the fix may be off by beyond that of an RTK.
Length kept_by(const Vehicle& v, Length safety) {
  const Length error = v.gnss.bias + 4.0 * std::max(Length{}, v.gnss.sigma - rtk_sigma);
  return std::max(Length{}, kept_share * safety - error);
}

class ClearanceLaws final : public Checker {
 public:
  explicit ClearanceLaws(const Facts& facts) {
    if (facts.plan.safety <= Length{}) return;
    for (const Obstacle& o : facts.field.obstacles) obstacles_.push_back({o, Instant::min()});
    for (const Surprise& s : facts.surprises) {
      obstacles_.push_back({{s.id, s.obstacle.center, s.obstacle.radius, {}}, s.appears});
    }
    for (const auto& uav : facts.plan.uavs) {
      aircraft_[uav.vehicle.id] = {kept_by(uav.vehicle, facts.plan.safety),
                                   planned_acceleration(uav.vehicle)};
    }
  }

  void observe(const Envelope& e) override {
    const auto* flown = std::get_if<FlightRecord>(&e.body);
    if (flown == nullptr) return;
    const auto aircraft = aircraft_.find(flown->agent);
    if (aircraft == aircraft_.end()) return;
    for (const TrackPoint& point : flown->track) {
      for (const Standing& obstacle : obstacles_) {
        judge(flown->agent, aircraft->second, obstacle, point);
      }
      aircraft->second.last = point;
    }
  }

  void conclude(Instant) override {}

  const std::optional<Clearance>& least() const { return least_; }

 private:
  struct Standing {
    Obstacle what;
    Instant since;
  };

  struct Aircraft {
    Length kept;
    Acceleration brakes;
    std::optional<TrackPoint> last{};
    /// Obstacles that came up too near, until when at least; then until it is clear of them.
    std::map<std::string, Instant> excused{};
  };

  void judge(AgentId agent, Aircraft& aircraft, const Standing& obstacle, const TrackPoint& point) {
    if (point.at < obstacle.since) return;
    const Obstacle& o = obstacle.what;
    if (comes_up(aircraft, obstacle)) excuse(aircraft, o, point);
    const Length about = distance(o.center, point.position) - o.radius;
    const auto excuse = aircraft.excused.find(o.id);
    const bool is_excused = excuse != aircraft.excused.end();
    const bool is_nearest = !is_excused && (!least_ || about < least_->away);
    if (about >= aircraft.kept && !is_nearest) {
      if (is_excused && point.at > excuse->second) aircraft.excused.erase(excuse);
      return;
    }
    const Length away = distance_to(o, point);
    if (is_nearest && (!least_ || away < least_->away)) least_ = {agent, o.id, away, point.at};
    if (away >= aircraft.kept) {
      if (is_excused && point.at > excuse->second) aircraft.excused.erase(excuse);
    } else if (!is_excused) {
      tell(agent, o, away, aircraft.kept, point.at);
    }
  }

  static Length distance_to(const Obstacle& o, const TrackPoint& point) {
    return -depth_in(o, point.position);
  }

  // Whether it is there since the last point of the track.
  static bool comes_up(const Aircraft& aircraft, const Standing& obstacle) {
    return aircraft.last && aircraft.last->at < obstacle.since;
  }

  // Where it cannot see, decide and stop before it, from the speed at which it came.
  static void excuse(Aircraft& aircraft, const Obstacle& o, const TrackPoint& point) {
    constexpr Seconds reaction = seconds(0.3);
    const Seconds took = seconds(point.at - aircraft.last->at);
    if (took <= Seconds{}) return;
    const Speed speed = distance(aircraft.last->position, point.position) / took;
    const Seconds stops = reaction + speed / aircraft.brakes;
    const Length way = speed * (took + reaction) + speed * speed / (2.0 * aircraft.brakes);
    if (distance_to(o, point) >= aircraft.kept + way) return;
    aircraft.excused[o.id] = point.at + duration(stops);
  }

  // Once for each aircraft and obstacle.
  void tell(AgentId agent, const Obstacle& obstacle, Length away, Length kept, Instant at) {
    if (!told_.insert({agent, obstacle.id}).second) return;
    report("L22", at,
           fmt::format("UAV {} was {:.2f} m from obstacle {}, less than {:.2f} m", number(agent),
                       away.base(), obstacle.id, kept.base()));
  }

  std::vector<Standing> obstacles_;
  std::map<AgentId, Aircraft> aircraft_;
  std::set<std::pair<AgentId, std::string>> told_;
  std::optional<Clearance> least_{};
};

}  // namespace

std::unique_ptr<Checker> clearance_laws(const Facts& facts) {
  return std::make_unique<ClearanceLaws>(facts);
}

std::optional<Clearance> least_clearance(const Facts& facts, const std::vector<Envelope>& log) {
  ClearanceLaws laws{facts};
  for (const Envelope& e : log) laws.observe(e);
  return laws.least();
}

}  // namespace furrow::sim
