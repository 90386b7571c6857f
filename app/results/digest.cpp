#include "app/results/digest.hpp"

#include <bit>
#include <fmt/format.h>
#include <string_view>

namespace furrow::app {
namespace {

// Every value is hashed as its eight bytes, low byte first, so that machines agree.
class Hash {
 public:
  void operator()(std::uint64_t value) {
    for (int byte = 0; byte < 8; ++byte) {
      state_ = (state_ ^ (value >> (8 * byte) & 0xff)) * 0x100000001b3u;
    }
  }
  void operator()(double value) { (*this)(std::bit_cast<std::uint64_t>(value)); }
  void operator()(float value) { (*this)(static_cast<double>(value)); }
  void operator()(Instant at) {
    (*this)(static_cast<std::uint64_t>(at.time_since_epoch().count()));
  }
  template <int M, int S, int L>
  void operator()(Quantity<M, S, L> value) {
    (*this)(value.base());
  }
  void operator()(FieldPoint p) { all(p.x, p.y); }
  void operator()(CellRange r) { all(std::uint64_t{r.first}, std::uint64_t{r.count}); }
  void operator()(std::string_view text) {
    (*this)(std::uint64_t{text.size()});
    for (const char c : text) (*this)(std::uint64_t{static_cast<unsigned char>(c)});
  }
  template <class T>
  requires std::is_enum_v<T> || std::is_same_v<T, std::uint32_t> || std::is_same_v<T, bool>
  void operator()(T value) { (*this)(static_cast<std::uint64_t>(value)); }
  template <class T>
  void operator()(const std::vector<T>& values) {
    (*this)(std::uint64_t{values.size()});
    for (const T& value : values) (*this)(value);
  }

  void operator()(const Vehicle& v) {
    all(v.id, v.home, v.swath, v.spray_speed, v.ferry_speed, v.spray_endurance, v.flight_endurance,
        v.battery_reserve, v.tank, v.min_turn_radius, v.acceleration_limit, v.gnss.sigma,
        v.gnss.bias);
    if (v.available_from > Seconds{} || v.available_until) {
      all(v.available_from, v.available_until.value_or(Seconds{}));
    }
  }
  void operator()(const Piece& p) {
    all(p.cells, p.entry, p.from, p.to);
    if (!(p.exit == p.to) || !p.approach.empty()) all(p.exit, p.approach);
    if (!p.approach_altitudes_m.empty()) all(p.approach_altitudes_m);
    if (p.width > Length{}) all(p.width);
  }
  void operator()(const SortieOrder& s) { all(s.pieces, s.station); }
  void operator()(const GrantWindow& w) { all(w.id, w.cells); }
  void operator()(const Closure& c) { all(c.grant, c.cells, c.sprayed, c.reason, c.at); }
  void operator()(const BayState& b) { all(b.bay, b.occupied, b.agent, b.token, b.ready); }
  void operator()(const TrackPoint& p) {
    all(p.at, p.position, p.spraying);
    if (p.altitude_m != 0) all(p.altitude_m);
    if (p.width > Length{}) all(p.width);
  }
  void operator()(const FlightRecord::Deviation& d) {
    all(std::uint64_t{d.samples}, d.sum_squares, d.largest);
  }

  void operator()(const AgentInfo& m) { all(m.agent, m.vehicle); }
  void operator()(const AgentState& m) {
    all(m.agent, m.epoch, m.revision, m.phase, m.position, m.heading_rad, m.ground_speed, m.tank,
        m.battery, m.sortie, m.last_grant, m.last_closed);
  }
  void operator()(const SeenObstacle& o) { all(o.center, o.radius); }
  void operator()(const Command& m) {
    all(m.agent, m.epoch, m.revision, m.sorties);
    if (!m.obstacles.empty()) all(m.obstacles);
  }
  void operator()(const CommandAck& m) {
    all(m.agent, m.epoch, m.revision, m.status, std::string_view{m.reason});
  }
  void operator()(const WorkGrant& m) {
    all(m.agent, m.epoch, m.revision, m.closed_through, m.windows);
  }
  void operator()(const WorkReport& m) { all(m.agent, m.epoch, m.closures); }
  void operator()(const ServiceClaim& m) {
    all(m.agent, m.station, m.claim, m.first_claimed, m.status, m.token, m.swap, m.fill);
  }
  void operator()(const ServiceGrant& m) {
    all(m.agent, m.station, m.claim, m.bay, m.token, m.starts, m.ready, m.expires, m.swap, m.fill);
  }
  void operator()(const StationState& m) {
    all(m.station, m.bays, m.queue, m.swaps, m.filled, m.open_bays, m.next_free);
  }
  void operator()(const SchedulerState& m) {
    all(m.epoch, m.phase, m.completed, m.sprayed_cells, m.open_cells, m.abandoned_cells, m.lost);
  }
  void operator()(const Event& m) { all(std::string_view{m.kind}, std::string_view{m.detail}); }
  void operator()(const SortieReport& m) {
    all(m.agent, m.sortie, m.resumed_at, m.returned_at, m.sprayed, m.ferried, m.flight, m.pack,
        m.battery_used, m.began, m.spray_ended, m.landed, m.serviced, m.station, m.bay, m.swapped,
        m.filled, m.wait, m.swap_time, m.fill_time);
  }
  void operator()(const FlightRecord& m) {
    all(m.agent, m.cells, m.offsets_m, m.truth, m.fix, m.track);
  }
  void operator()(const ObstacleSeen& m) {
    all(m.agent, m.epoch, m.revision, m.obstacle, m.clearance);
  }
  void operator()(const OperatorState& m) {
    all(m.epoch, m.revision, m.level, m.taken_out, m.answered, std::string_view{m.refusal});
  }
  void operator()(const OperatorOrder& m) { all(m.number, m.ask, m.agent); }
  void operator()(const TimedPlace& p) { all(p.at, p.position, p.altitude_m); }
  void operator()(const FlightClaim& m) { all(m.agent, m.claim, m.departure, m.leads_to, m.track); }
  void operator()(const FlightGrant& m) { all(m.agent, m.claim, m.is_clear, m.departs); }

  void operator()(const Envelope& e) {
    all(e.from.kind, e.from.number, e.seq, e.sent, std::uint64_t{e.body.index()});
    std::visit([this](const auto& body) { (*this)(body); }, e.body);
  }

  std::uint64_t value() const { return state_; }

 private:
  template <class... T>
  void all(const T&... values) {
    ((*this)(values), ...);
  }

  std::uint64_t state_ = 0xcbf29ce484222325u;
};

}  // namespace

std::string digest(const std::vector<Envelope>& log) {
  Hash hash;
  for (const Envelope& envelope : log) hash(envelope);
  return fmt::format("{:016x}", hash.value());
}

}  // namespace furrow::app
