#pragma once
// The format of scenario files: every key, its range and its default, one line each.

#include "mission/reader.hpp"
#include "mission/scenario.hpp"

#include <cstddef>
#include <vector>

namespace furrow::mission {

/// Where an obstacle is told of.
struct ObstacleEntry {
  Section at;
  std::string sight_key, place_key;  ///< Of `at`: how far it is seen, and where it stands.
  std::string value;                 ///< What it is of a file; empty: the value at the key.
};

/// A scenario as read, and the parts of the file that checks across keys point at.
struct Draft {
  Scenario scenario;
  std::vector<Section> stations;      ///< One for each station, in the scenario's order.
  std::vector<Section> fleets;        ///< The entries of `uavs`.
  std::vector<std::size_t> fleet_of;  ///< For each UAV, the index of its entry.
  std::vector<bool> has_start;        ///< For each entry, whether it says where its UAVs start.
  std::vector<Section> faults;
  std::vector<ObstacleEntry> obstacles;  ///< That the plan knows, in the field's order.
  std::vector<ObstacleEntry> surprises;  ///< In the scenario's order.
  /// Whether each key of the part is in order by itself.
  bool field_in_order, supply_in_order, fleet_in_order, faults_in_order;
};

/// Reads every key of the format.
Draft read_scenario(const Section& root);

}  // namespace furrow::mission
