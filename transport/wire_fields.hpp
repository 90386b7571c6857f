#pragma once
// One list of fields for each message, read in both directions: what is encoded is what is decoded.

#include "transport/wire.hpp"

#include <cmath>
#include <optional>
#include <type_traits>

namespace furrow::transport {

inline constexpr std::size_t longest_sequence = 1'000'000;

/// Instants on the wire are within 30 years of the epoch, so sums with any duration of a mission
/// stay far from the ends of the clock. Before the epoch lies the start on the wall clock.
inline constexpr std::int64_t farthest_ns = 1'000'000'000'000'000'000;

/// Core value to wire field.
struct Encode {
  template <class Core, class Wire>
  void operator()(const Core& value, Wire& field) {
    if constexpr (std::is_enum_v<Core>) {
      field = static_cast<Wire>(value);
    } else if constexpr (std::is_same_v<Core, Instant>) {
      field = value.time_since_epoch().count();
    } else if constexpr (requires { value.base(); }) {
      field = value.base();
    } else {
      field = value;
    }
  }
  template <class Core, class Wire>
  void positive(const std::optional<Core>& value, Wire& field) {
    field = value ? value->base() : 0;
  }
  template <class Core, class Wire>
  void bounded(Core value, Wire& field, Core, Core) {
    field = static_cast<Wire>(value);
  }
  template <class Core, class Wire, class Each>
  void sequence(const std::vector<Core>& values, std::vector<Wire>& items, Each each) {
    items.resize(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) each(*this, values[i], items[i]);
  }
};

/// Wire field to core value; `valid` falls when a field breaks the contract.
struct Decode {
  bool valid = true;

  template <class Core, class Wire>
  void operator()(Core& value, const Wire& field) {
    if constexpr (std::is_floating_point_v<Wire>) valid = valid && std::isfinite(field);
    if constexpr (std::is_enum_v<Core>) {
      value = static_cast<Core>(field);
    } else if constexpr (std::is_same_v<Core, Instant>) {
      valid = valid && field >= -farthest_ns && field <= farthest_ns;
      value = Instant{Duration{valid ? field : 0}};
    } else if constexpr (requires { value.base(); }) {
      value = Core::from_base(field);
    } else {
      value = field;
    }
  }
  /// 0: none.
  template <class Core, class Wire>
  void positive(std::optional<Core>& value, const Wire& field) {
    valid = valid && std::isfinite(field) && field >= 0;
    value = field > 0 ? std::optional{Core::from_base(field)} : std::nullopt;
  }
  template <class Core, class Wire>
  void bounded(Core& value, const Wire& field, Core low, Core high) {
    valid = valid && field >= static_cast<Wire>(low) && field <= static_cast<Wire>(high);
    value = valid ? static_cast<Core>(field) : low;
  }
  template <class Core, class Wire, class Each>
  void sequence(std::vector<Core>& values, std::vector<Wire>& items, Each each) {
    valid = valid && items.size() <= longest_sequence;
    if (!valid) return;
    values.resize(items.size());
    for (std::size_t i = 0; i < items.size(); ++i) each(*this, values[i], items[i]);
  }
};

/// A core message seen from either direction: const when encoding.
template <class Direction, class Core>
using Seen = std::conditional_t<std::is_same_v<Direction, Encode>, const Core, Core>;

template <class D>
void fields(D& d, Seen<D, FieldPoint>& m, fleet::v1::Point& w) {
  d(m.x, w.east_m());
  d(m.y, w.north_m());
}

template <class D>
void fields(D& d, Seen<D, CellRange>& m, fleet::v1::CellRange& w) {
  d(m.first, w.first());
  d(m.count, w.count());
}

template <class D>
void fields(D& d, Seen<D, AgentInfo>& m, fleet::v1::AgentInfo& w) {
  d(m.agent, w.agent());
  d(m.vehicle.id, w.agent());
  d(m.boot, w.header().boot_id());
  fields(d, m.vehicle.home, w.home_position());
  d(m.vehicle.swath, w.swath_m());
  d(m.vehicle.spray_speed, w.spray_speed_mps());
  d(m.vehicle.ferry_speed, w.ferry_speed_mps());
  d(m.vehicle.spray_endurance, w.spray_endurance_s());
  d(m.vehicle.flight_endurance, w.flight_endurance_s());
  d(m.vehicle.battery_reserve, w.battery_reserve_share());
  d(m.vehicle.tank, w.tank_l());
  d(m.vehicle.min_turn_radius, w.min_turn_radius_m());
  d(m.vehicle.acceleration_limit, w.acceleration_limit_mps2());
  d(m.vehicle.gnss.sigma, w.gnss_sigma_m());
  d(m.vehicle.gnss.bias, w.gnss_bias_m());
  d(m.vehicle.available_from, w.available_from_s());
  d.positive(m.vehicle.available_until, w.available_until_s());
}

template <class D>
void fields(D& d, Seen<D, AgentState>& m, fleet::v1::AgentState& w) {
  d(m.agent, w.agent());
  d(m.boot, w.header().boot_id());
  d(m.epoch, w.header().epoch());
  d(m.revision, w.revision());
  d.bounded(m.phase, w.phase(), Phase::idle, Phase::offline);
  fields(d, m.position, w.position());
  d(m.heading_rad, w.heading_rad());
  d(m.ground_speed, w.ground_speed_mps());
  d(m.tank, w.tank_share());
  d(m.battery, w.battery_share());
  d(m.sortie, w.sortie());
  d(m.last_grant, w.last_grant_id());
  d(m.last_closed, w.last_closed_id());
}

template <class D>
void fields(D& d, Seen<D, SeenObstacle>& m, fleet::v1::Obstacle& w) {
  fields(d, m.center, w.center());
  d(m.radius, w.radius_m());
}

template <class D>
void fields(D& d, Seen<D, Command>& m, fleet::v1::Command& w) {
  d(m.agent, w.agent());
  d(m.target_boot, w.target_boot_id());
  d(m.epoch, w.header().epoch());
  d(m.revision, w.revision());
  d.sequence(m.sorties, w.sorties(), [](D& s, auto& order, fleet::v1::SortieOrder& o) {
    s(order.station, o.station());
    s.sequence(order.pieces, o.pieces(), [](D& p, auto& piece, fleet::v1::Piece& q) {
      fields(p, piece.cells, q.cells());
      fields(p, piece.entry, q.entry());
      fields(p, piece.from, q.first());
      fields(p, piece.to, q.last());
      fields(p, piece.exit, q.exit());
      p.sequence(piece.approach, q.approach(),
                 [](D& a, auto& point, fleet::v1::Point& at) { fields(a, point, at); });
      p.sequence(piece.approach_altitudes_m, q.approach_altitude_m(),
                 [](D& a, auto& altitude_m, double& on_wire) { a(altitude_m, on_wire); });
      p(piece.width, q.width_m());
    });
  });
  d.sequence(m.obstacles, w.obstacles(),
             [](D& s, auto& obstacle, fleet::v1::Obstacle& o) { fields(s, obstacle, o); });
}

template <class D>
void fields(D& d, Seen<D, CommandAck>& m, fleet::v1::CommandAck& w) {
  d(m.agent, w.agent());
  d(m.boot, w.header().boot_id());
  d(m.epoch, w.header().epoch());
  d(m.revision, w.revision());
  d.bounded(m.status, w.status(), AckStatus::received, AckStatus::cancelled);
  d(m.reason, w.reason());
}

template <class D>
void fields(D& d, Seen<D, WorkGrant>& m, fleet::v1::WorkGrant& w) {
  d(m.agent, w.agent());
  d(m.target_boot, w.target_boot_id());
  d(m.epoch, w.header().epoch());
  d(m.revision, w.revision());
  d(m.closed_through, w.closed_through_id());
  d.sequence(m.windows, w.windows(), [](D& s, auto& window, fleet::v1::GrantWindow& g) {
    s(window.id, g.id());
    fields(s, window.cells, g.cells());
  });
}

template <class D>
void fields(D& d, Seen<D, WorkReport>& m, fleet::v1::WorkReport& w) {
  d(m.agent, w.agent());
  d(m.boot, w.header().boot_id());
  d(m.epoch, w.header().epoch());
  d.sequence(m.closures, w.closures(), [](D& s, auto& closure, fleet::v1::Closure& c) {
    s(closure.grant, c.grant_id());
    fields(s, closure.cells, c.cells());
    s(closure.sprayed, c.sprayed_cells());
    s.bounded(closure.reason, c.reason(), CloseReason::sprayed, CloseReason::recalled);
    s(closure.at, c.at_ns());
  });
}

template <class D>
void fields(D& d, Seen<D, ServiceClaim>& m, fleet::v1::ServiceClaim& w) {
  d(m.agent, w.agent());
  d(m.boot, w.header().boot_id());
  d(m.station, w.station());
  d(m.claim, w.claim_id());
  d(m.first_claimed, w.first_claimed_ns());
  d.bounded(m.status, w.status(), ClaimStatus::waiting, ClaimStatus::released);
  d(m.token, w.token());
  d(m.swap, w.swap());
  d(m.fill, w.fill_share());
}

template <class D>
void fields(D& d, Seen<D, ServiceGrant>& m, fleet::v1::ServiceGrant& w) {
  d(m.agent, w.agent());
  d(m.station, w.station());
  d(m.claim, w.claim_id());
  d(m.bay, w.bay());
  d(m.token, w.token());
  d(m.starts, w.starts_ns());
  d(m.ready, w.ready_ns());
  d(m.expires, w.expires_ns());
  d(m.swap, w.swap());
  d(m.fill, w.fill_share());
}

template <class D>
void fields(D& d, Seen<D, StationState>& m, fleet::v1::StationState& w) {
  d(m.station, w.station());
  d.sequence(m.bays, w.bays(), [](D& s, auto& bay, fleet::v1::BayState& b) {
    s(bay.bay, b.bay());
    s(bay.occupied, b.occupied());
    s(bay.agent, b.agent());
    s(bay.token, b.token());
    s(bay.ready, b.ready_ns());
  });
  d.sequence(m.queue, w.queue_agents(), [](D& s, auto& agent, std::uint32_t& a) { s(agent, a); });
  d(m.swaps, w.swaps());
  d(m.filled, w.filled_l());
  d(m.open_bays, w.open_bays());
  d(m.next_free, w.next_free_ns());
}

template <class D>
void fields(D& d, Seen<D, SchedulerState>& m, fleet::v1::SchedulerState& w) {
  d(m.epoch, w.header().epoch());
  d.bounded(m.phase, w.phase(), MissionPhase::gathering, MissionPhase::finished);
  d(m.completed, w.completed());
  d(m.sprayed_cells, w.sprayed_cells());
  d(m.open_cells, w.open_cells());
  d(m.abandoned_cells, w.abandoned_cells());
  d.sequence(m.lost, w.lost_agents(), [](D& s, auto& agent, std::uint32_t& a) { s(agent, a); });
}

template <class D>
void fields(D& d, Seen<D, Event>& m, fleet::v1::Event& w) {
  d(m.kind, w.kind());
  d(m.detail, w.detail());
}

template <class D>
void fields(D& d, Seen<D, SortieReport>& m, fleet::v1::SortieReport& w) {
  d(m.agent, w.agent());
  d(m.sortie, w.sortie());
  fields(d, m.resumed_at, w.resumed_at());
  fields(d, m.returned_at, w.returned_at());
  d(m.sprayed, w.sprayed_m());
  d(m.ferried, w.ferried_m());
  d(m.flight, w.flight_s());
  d(m.pack, w.pack());
  d(m.battery_used, w.battery_used_share());
  d(m.began, w.began_ns());
  d(m.spray_ended, w.spray_ended_ns());
  d(m.landed, w.landed_ns());
  d(m.serviced, w.serviced());
  d(m.station, w.station());
  d(m.bay, w.bay());
  d(m.swapped, w.swapped());
  d(m.filled, w.filled_share());
  d(m.wait, w.wait_s());
  d(m.swap_time, w.swap_s());
  d(m.fill_time, w.fill_s());
}

template <class D>
void fields(D& d, Seen<D, FlightRecord::Deviation>& m, fleet::v1::Deviation& w) {
  d(m.samples, w.samples());
  d(m.sum_squares, w.sum_squares_m2());
  d(m.largest, w.largest_m());
}

template <class D>
void fields(D& d, Seen<D, FlightRecord>& m, fleet::v1::FlightRecord& w) {
  d(m.agent, w.agent());
  fields(d, m.cells, w.cells());
  d.sequence(m.offsets_m, w.offsets_m(), [](D& s, auto& offset, float& o) { s(offset, o); });
  fields(d, m.truth, w.truth());
  fields(d, m.fix, w.fix());
  d.sequence(m.track, w.track(), [](D& s, auto& point, fleet::v1::TrackPoint& p) {
    s(point.at, p.at_ns());
    fields(s, point.position, p.position());
    s(point.spraying, p.spraying());
    s(point.altitude_m, p.altitude_m());
    s(point.width, p.width_m());
  });
}

template <class D>
void fields(D& d, Seen<D, ObstacleSeen>& m, fleet::v1::ObstacleSeen& w) {
  d(m.agent, w.agent());
  d(m.boot, w.header().boot_id());
  d(m.epoch, w.header().epoch());
  d(m.revision, w.revision());
  fields(d, m.obstacle, w.obstacle());
  d(m.clearance, w.clearance_m());
}

template <class D>
void fields(D& d, Seen<D, OperatorState>& m, fleet::v1::OperatorState& w) {
  d(m.epoch, w.header().epoch());
  d(m.revision, w.revision());
  d.bounded(m.level, w.level(), FleetLevel::fly, FleetLevel::end);
  d.sequence(m.taken_out, w.taken_out_agents(),
             [](D& s, auto& agent, std::uint32_t& a) { s(agent, a); });
  d(m.answered, w.answered_order());
  d(m.refusal, w.refusal());
}

template <class D>
void fields(D& d, Seen<D, OperatorOrder>& m, fleet::v1::OperatorOrder& w) {
  d(m.number, w.number());
  d.bounded(m.ask, w.ask(), OperatorAsk::pause, OperatorAsk::take_out);
  d(m.agent, w.agent());
}

template <class D>
void fields(D& d, Seen<D, FlightClaim>& m, fleet::v1::FlightClaim& w) {
  d(m.agent, w.agent());
  d(m.boot, w.header().boot_id());
  d(m.claim, w.claim_id());
  d.bounded(m.departure, w.departure(), Departure::from_ground, Departure::begun);
  fields(d, m.leads_to, w.leads_to());
  d.sequence(m.track, w.track(), [](D& s, auto& place, fleet::v1::TimedPlace& p) {
    s(place.at, p.at_ns());
    fields(s, place.position, p.position());
    s(place.altitude_m, p.altitude_m());
  });
}

template <class D>
void fields(D& d, Seen<D, FlightGrant>& m, fleet::v1::FlightGrant& w) {
  d(m.agent, w.agent());
  d(m.target_boot, w.target_boot_id());
  d(m.claim, w.claim_id());
  d(m.is_clear, w.is_clear());
  d(m.departs, w.departs_ns());
}

}  // namespace furrow::transport
