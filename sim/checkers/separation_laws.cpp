#include "sim/checkers/laws.hpp"
#include "sim/checkers/separation.hpp"

#include <fmt/format.h>
#include <map>

namespace furrow::sim {
namespace {

class SeparationLaws final : public Checker {
 public:
  explicit SeparationLaws(const Facts& facts) : separation_{facts.separation} {}

  void observe(const Envelope& e) override {
    if (!separation_) return;
    const auto* flown = std::get_if<FlightRecord>(&e.body);
    if (flown == nullptr) return;
    auto& track = tracks_[flown->agent];
    track.insert(track.end(), flown->track.begin(), flown->track.end());
  }

  void conclude(Instant) override {
    if (!separation_) return;
    std::vector<AgentId> agents;
    std::vector<std::vector<TrackPoint>> tracks;
    for (auto& [agent, track] : tracks_) {
      agents.push_back(agent);
      tracks.push_back(std::move(track));
    }
    for (const Encounter& e : separation(tracks, separation_->base()).encounters) {
      report("L24", e.from,
             fmt::format("UAVs {} and {} were {:.2f} m from each other, less than {:.2f} m",
                         number(agents[e.first]), number(agents[e.second]), e.closest_m,
                         separation_->base()));
    }
  }

 private:
  std::optional<Length> separation_;
  std::map<AgentId, std::vector<TrackPoint>> tracks_;
};

}  // namespace

std::unique_ptr<Checker> separation_laws(const Facts& facts) {
  return std::make_unique<SeparationLaws>(facts);
}

}  // namespace furrow::sim
