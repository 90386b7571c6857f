#include "app/results/report/timeline.hpp"

namespace furrow::app {
namespace {

std::vector<Span> from_sorties(const std::vector<SortieFigures>& sorties) {
  std::vector<Span> spans;
  for (const SortieFigures& s : sorties) {
    spans.push_back({s.began_s, s.spray_began_s, Phase::fly_out});
    spans.push_back({s.spray_began_s, s.spray_ended_s, Phase::spray});
    spans.push_back({s.spray_ended_s, s.landed_s, Phase::fly_back});
    if (s.bay == 0) continue;
    spans.push_back({s.landed_s, s.service_began_s, Phase::wait});
    spans.push_back({s.service_began_s, s.ready_s, Phase::service});
  }
  return spans;
}

}  // namespace

std::vector<std::vector<Span>> timelines(const Result& result, const Flown& flown) {
  std::vector<std::vector<Span>> all;
  for (std::size_t i = 0; i < result.uavs.size(); ++i) {
    const bool has_heartbeats = i < flown.uavs.size() && !flown.uavs[i].phases.empty();
    all.push_back(has_heartbeats ? flown.uavs[i].phases : from_sorties(result.uavs[i].sorties));
  }
  return all;
}

}  // namespace furrow::app
