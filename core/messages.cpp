#include "core/messages.hpp"

namespace furrow {
namespace {

struct Recipient {
  NodeId to;

  bool is_scheduler() const { return to.kind == NodeKind::scheduler; }

  bool operator()(const AgentInfo&) const { return is_scheduler(); }
  bool operator()(const AgentState&) const { return is_scheduler(); }
  bool operator()(const CommandAck&) const { return is_scheduler(); }
  bool operator()(const WorkReport&) const { return is_scheduler(); }
  bool operator()(const StationState&) const { return is_scheduler(); }
  bool operator()(const Command& m) const { return to == node(m.agent); }
  bool operator()(const WorkGrant& m) const { return to == node(m.agent); }
  bool operator()(const ServiceGrant& m) const { return to == node(m.agent); }
  bool operator()(const ServiceClaim& m) const { return to == node(m.station); }
  bool operator()(const SchedulerState&) const { return to.kind == NodeKind::agent; }
  bool operator()(const Event&) const { return false; }
  bool operator()(const SortieReport&) const { return false; }
  bool operator()(const FlightRecord&) const { return false; }
  bool operator()(const ObstacleSeen&) const { return is_scheduler(); }
  bool operator()(const OperatorState&) const { return to.kind == NodeKind::agent; }
  bool operator()(const OperatorOrder&) const { return is_scheduler(); }
  bool operator()(const FlightClaim&) const { return is_scheduler(); }
  bool operator()(const FlightGrant& m) const { return to == node(m.agent); }
};

}  // namespace

std::string_view name(FleetLevel level) {
  switch (level) {
    case FleetLevel::fly: return "fly";
    case FleetLevel::hold: return "hold";
    case FleetLevel::land: return "land";
    case FleetLevel::end: return "end";
  }
  return "unknown";
}

std::string_view name(OperatorAsk ask) {
  switch (ask) {
    case OperatorAsk::pause: return "pause";
    case OperatorAsk::resume: return "resume";
    case OperatorAsk::return_all: return "return_all";
    case OperatorAsk::stop: return "stop";
    case OperatorAsk::take_out: return "take_out";
  }
  return "unknown";
}

bool is_recipient(NodeId to, const Envelope& envelope) {
  return std::visit(Recipient{to}, envelope.body);
}

bool ends_mission(const Envelope& envelope) {
  const auto* const state = std::get_if<SchedulerState>(&envelope.body);
  return state != nullptr && state->phase == MissionPhase::finished;
}

}  // namespace furrow
