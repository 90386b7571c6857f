#include "app/results/events_jsonl.hpp"

#include "app/results/rounding.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace furrow::app {
namespace {

using Json = nlohmann::ordered_json;

double at_s(Instant at) { return rounded(seconds(at).base()); }
Json point(FieldPoint p) { return Json::array({rounded(p.x.base()), rounded(p.y.base())}); }

const char* name(AckStatus status) {
  switch (status) {
    case AckStatus::received: return "received";
    case AckStatus::accepted: return "accepted";
    case AckStatus::rejected: return "rejected";
    case AckStatus::running: return "running";
    case AckStatus::done: return "done";
    case AckStatus::failed: return "failed";
    case AckStatus::cancelled: return "cancelled";
  }
  return "unknown";
}

const char* name(CloseReason reason) {
  switch (reason) {
    case CloseReason::sprayed: return "sprayed";
    case CloseReason::tank_low: return "tank_low";
    case CloseReason::battery_low: return "battery_low";
    case CloseReason::superseded: return "superseded";
    case CloseReason::strayed: return "strayed";
    case CloseReason::blocked: return "blocked";
    case CloseReason::recalled: return "recalled";
  }
  return "unknown";
}

const char* name(ClaimStatus status) {
  switch (status) {
    case ClaimStatus::waiting: return "waiting";
    case ClaimStatus::in_bay: return "in_bay";
    case ClaimStatus::released: return "released";
  }
  return "unknown";
}

const char* name(Departure departure) {
  switch (departure) {
    case Departure::from_ground: return "from_ground";
    case Departure::from_hover: return "from_hover";
    case Departure::in_motion: return "in_motion";
    case Departure::begun: return "begun";
  }
  return "unknown";
}

// Adds what a message says to its line.
struct Details {
  Json& line;

  void operator()(const AgentInfo& m) {
    line["agent"] = number(m.agent);
    line["home_m"] = point(m.vehicle.home);
  }
  void operator()(const Command& m) {
    std::uint32_t cells = 0;
    for (const SortieOrder& sortie : m.sorties) {
      for (const Piece& piece : sortie.pieces) cells += piece.cells.count;
    }
    line["agent"] = number(m.agent);
    line["epoch"] = number(m.epoch);
    line["revision"] = m.revision;
    line["sorties"] = m.sorties.size();
    line["cells"] = cells;
  }
  void operator()(const CommandAck& m) {
    line["agent"] = number(m.agent);
    line["epoch"] = number(m.epoch);
    line["revision"] = m.revision;
    line["status"] = name(m.status);
    if (!m.reason.empty()) line["reason"] = m.reason;
  }
  void operator()(const WorkGrant& m) {
    line["agent"] = number(m.agent);
    line["epoch"] = number(m.epoch);
    line["revision"] = m.revision;
    line["closed_through"] = m.closed_through;
    line["windows"] = Json::array();
    for (const GrantWindow& w : m.windows) {
      line["windows"].push_back(
          {{"grant", w.id}, {"first_cell", w.cells.first}, {"cells", w.cells.count}});
    }
  }
  void operator()(const WorkReport& m) {
    line["agent"] = number(m.agent);
    line["epoch"] = number(m.epoch);
    line["closures"] = Json::array();
    for (const Closure& c : m.closures) {
      line["closures"].push_back({{"grant", c.grant},
                                  {"first_cell", c.cells.first},
                                  {"cells", c.cells.count},
                                  {"sprayed", c.sprayed},
                                  {"reason", name(c.reason)},
                                  {"at_s", at_s(c.at)}});
    }
  }
  void operator()(const ServiceClaim& m) {
    line["agent"] = number(m.agent);
    line["station"] = number(m.station);
    line["claim"] = m.claim;
    line["status"] = name(m.status);
    line["first_claimed_s"] = at_s(m.first_claimed);
    line["swap"] = m.swap;
    line["fill"] = rounded(m.fill);
    if (m.token > 0) line["token"] = m.token;
  }
  void operator()(const ServiceGrant& m) {
    line["agent"] = number(m.agent);
    line["station"] = number(m.station);
    line["claim"] = m.claim;
    line["bay"] = m.bay;
    line["token"] = m.token;
    line["starts_s"] = at_s(m.starts);
    line["ready_s"] = at_s(m.ready);
    line["swap"] = m.swap;
    line["fill"] = rounded(m.fill);
  }
  void operator()(const Event& m) {
    line["kind"] = m.kind;
    line["detail"] = m.detail;
  }
  void operator()(const SortieReport& m) {
    line["agent"] = number(m.agent);
    line["sortie"] = m.sortie + 1;
    line["start_m"] = point(m.resumed_at);
    line["return_m"] = point(m.returned_at);
    line["spray_m"] = rounded(m.sprayed.base());
    line["ferry_m"] = rounded(m.ferried.base());
    line["flight_s"] = rounded(m.flight.base());
    line["pack"] = m.pack;
    line["battery_used"] = rounded(m.battery_used);
    line["began_s"] = at_s(m.began);
    line["spray_ended_s"] = at_s(m.spray_ended);
    line["landed_s"] = at_s(m.landed);
    if (!m.serviced) return;
    line["station"] = number(m.station);
    line["bay"] = m.bay;
    line["wait_s"] = rounded(m.wait.base());
    line["battery_swap_s"] = m.swapped ? rounded(m.swap_time.base()) : 0.0;
    line["fill"] = rounded(m.filled);
    line["fill_s"] = rounded(m.fill_time.base());
  }
  void operator()(const ObstacleSeen& m) {
    line["agent"] = number(m.agent);
    line["center_m"] = point(m.obstacle.center);
    line["radius_m"] = rounded(m.obstacle.radius.base());
    line["clearance_m"] = rounded(m.clearance.base());
  }
  void operator()(const OperatorState& m) {
    line["revision"] = m.revision;
    line["level"] = furrow::name(m.level);
    line["taken_out"] = Json::array();
    for (const AgentId agent : m.taken_out) line["taken_out"].push_back(number(agent));
    if (m.answered > 0) line["answered"] = m.answered;
    if (!m.refusal.empty()) line["refusal"] = m.refusal;
  }
  void operator()(const OperatorOrder& m) {
    line["number"] = m.number;
    line["ask"] = furrow::name(m.ask);
    if (m.ask == OperatorAsk::take_out) line["agent"] = number(m.agent);
  }
  void operator()(const FlightClaim& m) {
    line["agent"] = number(m.agent);
    line["claim"] = m.claim;
    line["departure"] = name(m.departure);
    if (m.leads_to.count > 0) {
      line["first_cell"] = m.leads_to.first;
      line["cells"] = m.leads_to.count;
    }
    if (m.track.empty()) return;
    double highest_m = 0.0;
    for (const TimedPlace& p : m.track) highest_m = std::max(highest_m, p.altitude_m);
    line["from_s"] = at_s(m.track.front().at);
    line["to_s"] = at_s(m.track.back().at);
    line["from_m"] = point(m.track.front().position);
    line["to_m"] = point(m.track.back().position);
    line["highest_m"] = rounded(highest_m);
  }
  void operator()(const FlightGrant& m) {
    line["agent"] = number(m.agent);
    line["claim"] = m.claim;
    line["is_clear"] = m.is_clear;
    if (m.is_clear) line["departs_s"] = at_s(m.departs);
  }
  void operator()(const AgentState&) {}
  void operator()(const StationState&) {}
  void operator()(const SchedulerState&) {}
  void operator()(const FlightRecord&) {}
};

bool is_written(const Body& body) {
  return !std::holds_alternative<AgentState>(body) && !std::holds_alternative<StationState>(body) &&
         !std::holds_alternative<SchedulerState>(body) &&
         !std::holds_alternative<FlightRecord>(body);
}

}  // namespace

std::string events_jsonl(const std::vector<Envelope>& log) {
  std::string lines;
  for (const Envelope& e : log) {
    if (!is_written(e.body)) continue;
    Json line{{"t_s", at_s(e.sent)}, {"from", text(e.from)}, {"seq", e.seq}};
    line["topic"] = std::string{topic(e.body)};
    std::visit(Details{line}, e.body);
    lines += line.dump(-1, ' ', false, Json::error_handler_t::replace);
    lines += '\n';
  }
  return lines;
}

}  // namespace furrow::app
