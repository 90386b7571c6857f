#pragma once

#include "agents/aircraft.hpp"
#include "core/messages.hpp"

namespace furrow::agents {

/// Collects the true flight between two records.
class FlightLog {
 public:
  explicit FlightLog(AgentId agent) { record_.agent = agent; }

  /// A later word on the same instant replaces the earlier.
  /// @param width  As of the piece that is sprayed.
  void point(Instant at, Xy truth_m, double altitude_m, bool is_spraying, Length width = {});
  /// A place passed between points. It becomes a point itself where the line from the point before
  /// it to a later place would leave out the way by more than 3 cm, or its height by 10 cm.
  void pass(Instant at, Xy truth_m, double altitude_m, bool is_spraying, Length width = {});
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
  /// Keeps the last place passed where the straight line on would leave out the way.
  void keep_bend(Instant at, Xy ahead_m, double altitude_m);
  void keep(const TrackPoint& point);

  FlightRecord record_{};
  std::vector<TrackPoint> passed_;  ///< The last point and the places passed since.
};

}  // namespace furrow::agents
