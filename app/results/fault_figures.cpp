#include "app/results/fault_figures.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace furrow::app {
namespace {

// When an event of this kind first told of the node, at `from` or later.
std::optional<double> told_s(const std::vector<Envelope>& log, std::string_view kind, NodeId of,
                             Instant from = {}) {
  const std::string who = text(of) + " ";
  for (const Envelope& e : log) {
    const auto* event = std::get_if<Event>(&e.body);
    if (event == nullptr || event->kind != kind || e.sent < from) continue;
    if (event->detail.starts_with(who)) return seconds(e.sent).base();
  }
  return std::nullopt;
}

// The event by which the scheduler says that it obeys; none where nobody orders anything.
std::string_view obeyed(mission::Fault::Kind kind) {
  switch (kind) {
    case mission::Fault::Kind::pause: return "fleet_paused";
    case mission::Fault::Kind::resume: return "fleet_resumed";
    case mission::Fault::Kind::return_all: return "fleet_recalled";
    case mission::Fault::Kind::stop: return "mission_stopped";
    case mission::Fault::Kind::take_out: return "agent_taken_out";
    default: return {};
  }
}

std::optional<double> noticed_s(const mission::Fault& fault, const MissionRecord& record,
                                const Flown& flown) {
  using Kind = mission::Fault::Kind;
  if (fault.kind == Kind::agent_join) return told_s(record.log, "agent_joined", fault.target);
  if (fault.kind == Kind::bay_down) return told_s(record.log, "bay_down", fault.target, fault.at);
  if (const std::string_view event = obeyed(fault.kind); !event.empty()) {
    return told_s(record.log, event, fault.target, fault.at);
  }
  const auto lost = flown.lost.find(AgentId{fault.target.number});
  if (lost == flown.lost.end()) return std::nullopt;
  return seconds(lost->second).base();
}

}  // namespace

std::vector<FaultFigures> fault_figures(const MissionRecord& record, const Flown& flown) {
  std::vector<FaultFigures> faults;
  for (const mission::Fault& fault : record.scenario.faults) {
    FaultFigures f{.at_s = seconds(fault.at).base(),
                   .kind = mission::name(fault.kind),
                   .target = fault.target.number,
                   .noticed_s = noticed_s(fault, record, flown)};
    faults.push_back(std::move(f));
  }
  return faults;
}

}  // namespace furrow::app
