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
    if (const auto* flown = std::get_if<FlightRecord>(&e.body)) {
      auto& points = tracks_[flown->agent].points;
      points.insert(points.end(), flown->track.begin(), flown->track.end());
    } else if (const auto* sortie = std::get_if<SortieReport>(&e.body)) {
      std::vector<Instant>& landings = tracks_[sortie->agent].landings;
      if (landings.empty() || landings.back() < sortie->landed) landings.push_back(sortie->landed);
    }
  }

  void conclude(Instant) override {
    if (!separation_) return;
    std::vector<AgentId> agents;
    std::vector<AirTrack> tracks;
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
  std::map<AgentId, AirTrack> tracks_;
};

}  // namespace

std::unique_ptr<Checker> separation_laws(const Facts& facts) {
  return std::make_unique<SeparationLaws>(facts);
}

}  // namespace furrow::sim
