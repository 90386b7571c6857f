#pragma once

#include "agents/aircraft.hpp"
#include "core/messages.hpp"

namespace furrow::agents {

/// Collects the true flight between two records.
class FlightLog {
 public:
  explicit FlightLog(AgentId agent) { record_.agent = agent; }

  /// A later word on the same instant replaces the earlier.
  void point(Instant at, Xy truth_m, double altitude_m, bool is_spraying);
  /// A control period on a strip with the valve open.
  void sample(const Piece& strip, const Aircraft& aircraft);
  /// A cell passed with the valve open, in order of the route.
  void cell(std::uint32_t cell, const Piece& strip, const Aircraft& aircraft);

  bool is_empty() const { return record_.cells.count == 0 && record_.track.empty(); }
  /// Whether `cell` would not follow on those collected.
  bool would_break(std::uint32_t cell) const {
    return record_.cells.count > 0 && end(record_.cells) != cell;
  }
  /// Hands the record over and begins a new one.
  FlightRecord take();

 private:
  FlightRecord record_{};
};

}  // namespace furrow::agents
