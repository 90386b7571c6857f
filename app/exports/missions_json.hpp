#pragma once
// The planned sorties of a mission on disk: what `export` turns into other tools' files.

#include "core/expected.hpp"
#include "exchange/missions.hpp"

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace furrow::app {

struct Missions {
  std::optional<exchange::Datum> datum;  ///< None: the field has no known place on the globe.
  std::vector<exchange::SortieTrack> sorties;
};

/// {"lat_deg": ..., "lon_deg": ...}, or null.
nlohmann::ordered_json datum_json(const std::optional<exchange::Datum>& datum);

/// missions.json: metres in the field frame. A point is east, north, its height and that of the
/// ground above home, the valve as 0 or 1, and the width of the spray where only a part is open.
std::string missions_json(const Missions& missions);

/// Reads it back. The error is a sentence.
Expected<Missions, std::string> read_missions(const std::string& json);

}  // namespace furrow::app
