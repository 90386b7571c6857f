#include "sim/checkers/laws.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <set>
#include <utility>

namespace furrow::sim {
namespace {

constexpr double tolerance_m = 1.0;  // slopes between samples, errors of place, gusts
constexpr double slope_kept = 0.9;   // of what climb and descent allow: arcs are shorter

class HeightLaws final : public Checker {
 public:
  explicit HeightLaws(const Facts& facts)
      : relief_{facts.plan.route.ferries.relief()},
        is_survey_{planner::is_survey(facts.plan.route)} {
    for (const auto& uav : facts.plan.uavs) {
      speeds_[uav.vehicle.id] = uav.vehicle.ferry_speed;
      biases_[uav.vehicle.id] = uav.vehicle.gnss.bias;
    }
  }

  void observe(const Envelope& e) override {
    if (relief_ == nullptr) return;
    if (const auto* flown = std::get_if<FlightRecord>(&e.body)) {
      for (const TrackPoint& p : flown->track) judge_volumes(flown->agent, p);
      auto& track = tracks_[flown->agent];
      track.insert(track.end(), flown->track.begin(), flown->track.end());
    }
    if (const auto* sortie = std::get_if<SortieReport>(&e.body)) {
      const auto speed = speeds_.find(sortie->agent);
      if (speed != speeds_.end()) judge(*sortie, tracks_[sortie->agent], speed->second);
      tracks_[sortie->agent].clear();
    }
  }

  void conclude(Instant) override {}

 private:
  // Told once for each aircraft and volume.
  void judge_volumes(AgentId agent, const TrackPoint& p) {
    const auto& volumes = relief_->keep_out();
    for (std::size_t i = 0; i < volumes.size(); ++i) {
      const planner::KeepOut& volume = volumes[i];
      const double inside_m = volume.radius_m - biases_[agent].base() -
                              distance(p.position, at_m(volume.x_m, volume.y_m)).base();
      const bool is_beside = p.altitude_m < volume.bottom_m || p.altitude_m > volume.top_m;
      if (inside_m <= 0 || is_beside || !entered_.insert({agent, i}).second) continue;
      report("L25", p.at,
             fmt::format("{} flew {:.2f} m inside the keep-out volume at ({:.1f}, {:.1f}) m",
                         text(node(agent)), inside_m, volume.x_m, volume.y_m));
    }
  }

  // The first place that is too low or too high.
  void judge(const SortieReport& sortie, const std::vector<TrackPoint>& track, Speed ferry) {
    if (track.empty()) return;
    const auto first =
        std::find_if(track.begin(), track.end(), [](const TrackPoint& p) { return p.spraying; });
    const Instant begins = first == track.end() ? sortie.landed : first->at;
    const std::vector<FieldPoint> ends{track.front().position, sortie.resumed_at,
                                       sortie.returned_at, track.back().position};
    const auto ceiling = relief_->rule().ceiling;
    for (const TrackPoint& p : track) {
      const bool is_ferry = p.at < begins || p.at > sortie.spray_ended;
      const double kept_m = is_survey_ ? survey_m(p.position)
                            : is_ferry
                                ? ferry_m(p.position, ends, ferry, relief_->layer_of(sortie.agent))
                                : relief_->work_altitude_m(p.position);
      if (p.altitude_m < kept_m - tolerance_m) return tell(sortie.agent, p, kept_m, "least");
      if (ceiling && is_ferry && p.altitude_m > ceiling->base() + tolerance_m) {
        return tell(sortie.agent, p, ceiling->base(), "most");
      }
    }
  }

  void tell(AgentId agent, const TrackPoint& p, double kept_m, const char* which) {
    report("L23", p.at,
           fmt::format("{} flew at {:.1f} m over ({:.1f}, {:.1f}) m, {:.1f} m is the {} there",
                       text(node(agent)), p.altitude_m, p.position.x.base(), p.position.y.base(),
                       kept_m, which));
  }

  double survey_m(FieldPoint p) const {
    const planner::HeightRule& rule = relief_->rule();
    return (relief_->surface().height(p) + std::min(rule.clearance, rule.spray_height)).base();
  }

  double ferry_m(FieldPoint p, const std::vector<FieldPoint>& ends, Speed ferry,
                 Length layer) const {
    const planner::HeightRule& rule = relief_->rule();
    const double slope = slope_kept * (std::min(rule.climb, rule.descent) / ferry);
    double kept_m = (relief_->surface().height(p) + rule.clearance + layer).base();
    for (const FieldPoint end : ends) {
      kept_m = std::min(kept_m, relief_->work_altitude_m(end) + slope * distance(end, p).base());
    }
    return std::max(kept_m, relief_->work_altitude_m(p));
  }

  const planner::Relief* relief_;
  bool is_survey_;
  std::map<AgentId, Speed> speeds_;
  std::map<AgentId, Length> biases_;
  std::set<std::pair<AgentId, std::size_t>> entered_;
  std::map<AgentId, std::vector<TrackPoint>> tracks_;
};

}  // namespace

std::unique_ptr<Checker> height_laws(const Facts& facts) {
  return std::make_unique<HeightLaws>(facts);
}

}  // namespace furrow::sim
