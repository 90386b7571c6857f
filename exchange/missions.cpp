#include "exchange/missions.hpp"

#include "core/require.hpp"
#include "exchange/mission_items.hpp"
#include "exchange/track_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace furrow::exchange {

namespace {

using Writer = std::string (*)(const SortieTrack&, const LocalFrame&);

struct FormatRow {
  MissionFormat format;
  std::string_view name, extension;
  Writer writer;
};

constexpr std::array rows{FormatRow{MissionFormat::qgc_plan, "qgc-plan", "plan", qgc_plan},
                          FormatRow{MissionFormat::waypoints, "waypoints", "waypoints", waypoints},
                          FormatRow{MissionFormat::geojson, "geojson", "geojson", geojson},
                          FormatRow{MissionFormat::kml, "kml", "kml", kml},
                          FormatRow{MissionFormat::csv, "csv", "csv", csv}};

const FormatRow& row(MissionFormat format) { return rows[static_cast<std::size_t>(format)]; }

}  // namespace

std::optional<MissionFormat> mission_format(std::string_view name) {
  for (const FormatRow& row : rows) {
    if (row.name == name) return row.format;
  }
  return std::nullopt;
}

bool tells_width(MissionFormat format) {
  return format == MissionFormat::geojson || format == MissionFormat::csv;
}

std::string file_name(const SortieTrack& track, MissionFormat format) {
  return fmt::format("uav{}_sortie{}.{}", number(track.uav), track.sortie, row(format).extension);
}

std::optional<MissionFormat> format_of_file(std::string_view file_name) {
  const auto skip = [&](std::string_view word) {
    if (!file_name.starts_with(word)) return false;
    file_name.remove_prefix(word.size());
    return true;
  };
  const auto skip_number = [&] {
    const std::size_t digits =
        std::min(file_name.find_first_not_of("0123456789"), file_name.size());
    file_name.remove_prefix(digits);
    return digits > 0;
  };
  if (!skip("uav") || !skip_number() || !skip("_sortie") || !skip_number() || !skip(".")) return {};
  for (const FormatRow& row : rows) {
    if (row.extension == file_name) return row.format;
  }
  return std::nullopt;
}

std::string mission_file(const SortieTrack& track, const LocalFrame& frame, MissionFormat format) {
  require(!track.points.empty(), "a sortie flies over at least one point");
  return row(format).writer(track, frame);
}

}  // namespace furrow::exchange
