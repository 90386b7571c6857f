#include "app/results/flown.hpp"

#include <algorithm>
#include <set>
#include <tuple>

namespace furrow::app {
namespace {

class Reader {
 public:
  explicit Reader(const scheduler::FleetPlan& plan) {
    flown_.uavs.resize(plan.uavs.size());
    flown_.proofs.resize(plan.route.centers.size());
    for (std::size_t i = 0; i < plan.uavs.size(); ++i) index_[plan.uavs[i].vehicle.id] = i;
  }

  void read(const Envelope& envelope) {
    now_ = envelope.sent;
    std::visit([this](const auto& body) { take(body); }, envelope.body);
  }

  Flown flown() && {
    flown_.ended_s = seconds(now_).base();
    for (FlownUav& uav : flown_.uavs) {
      std::stable_sort(uav.sorties.begin(), uav.sorties.end(),
                       [](const auto& a, const auto& b) { return a.sortie < b.sortie; });
    }
    return std::move(flown_);
  }

 private:
  FlownUav* uav(AgentId id) {
    const auto found = index_.find(id);
    return found == index_.end() ? nullptr : &flown_.uavs[found->second];
  }

  void sprayed_until(Instant at) {
    flown_.last_spray_s = std::max(flown_.last_spray_s, seconds(at).base());
  }

  void take(const AgentState& state) {
    FlownUav* of = uav(state.agent);
    if (!of) return;
    const double now_s = seconds(now_).base();
    if (!of->phases.empty()) of->phases.back().to_s = now_s;
    if (of->phases.empty() || of->phases.back().phase != state.phase) {
      of->phases.push_back({now_s, now_s, state.phase});
    }
  }

  void take(const WorkReport& report) {
    for (const Closure& closure : report.closures) {
      if (!booked_.insert({report.agent, report.epoch, closure.grant}).second) continue;
      const auto cells = static_cast<std::uint32_t>(flown_.proofs.size());
      const CellRange sprayed{closure.cells.first, std::min(closure.sprayed, closure.cells.count)};
      for (std::uint32_t i = sprayed.first; i < std::min(end(sprayed), cells); ++i) {
        ++flown_.proofs[i];
      }
      if (sprayed.count > 0) sprayed_until(closure.at);
    }
  }

  void take(const SortieReport& report) {
    FlownUav* of = uav(report.agent);
    if (!of) return;
    std::erase_if(of->sorties,
                  [&](const SortieReport& told) { return told.sortie == report.sortie; });
    of->sorties.push_back(report);
    if (report.sprayed > Length{}) sprayed_until(report.spray_ended);
  }

  void take(const FlightRecord& record) {
    FlownUav* of = uav(record.agent);
    if (!of) return;
    const auto known = std::min<std::size_t>(record.cells.count, record.offsets_m.size());
    for (std::size_t i = 0; i < known; ++i) {
      const std::size_t cell = record.cells.first + i;
      if (cell >= flown_.proofs.size()) break;
      flown_.passes.push_back({static_cast<std::uint32_t>(cell), record.offsets_m[i]});
    }
    add(of->truth, record.truth);
    add(of->fix, record.fix);
    of->track.insert(of->track.end(), record.track.begin(), record.track.end());
  }

  static void add(FlightRecord::Deviation& sum, const FlightRecord::Deviation& more) {
    sum.samples += more.samples;
    sum.sum_squares += more.sum_squares;
    sum.largest = std::max(sum.largest, more.largest);
  }

  void take(const StationState& state) { flown_.stations[state.station] = state; }

  void take(const SchedulerState& state) {
    flown_.last_word = state;
    for (const AgentId id : state.lost) flown_.lost.emplace(id, now_);
  }

  void take(const OperatorState& state) { flown_.ordered = state; }

  template <class Other>
  void take(const Other&) {}

  Instant now_{};
  Flown flown_{};
  std::map<AgentId, std::size_t> index_;
  std::set<std::tuple<AgentId, Epoch, std::uint64_t>> booked_;  // reports repeat their closures
};

}  // namespace

Flown flown(const MissionRecord& record) {
  Reader reader{record.plan};
  for (const Envelope& envelope : record.log) reader.read(envelope);
  return std::move(reader).flown();
}

}  // namespace furrow::app
