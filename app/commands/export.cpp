#include "app/exports/missions_json.hpp"
#include "app/options.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <vector>

namespace furrow::app {
namespace {

namespace fs = std::filesystem;

int refused(const std::string& sentence) {
  fmt::print(stderr, "furrow: {}\n", sentence);
  return Exit::bad_input;
}

// Mission files of this format in the folder, from whatever export.
std::vector<fs::path> earlier_missions(const fs::path& folder, exchange::MissionFormat format) {
  std::vector<fs::path> files;
  std::error_code none;
  for (auto entry = fs::directory_iterator{folder, none};
       !none && entry != fs::directory_iterator{}; entry.increment(none)) {
    const bool is_mission = exchange::format_of_file(entry->path().filename().string()) == format;
    if (is_mission && entry->is_regular_file()) files.push_back(entry->path());
  }
  return files;
}

// Makes the folder, without earlier missions of this format. @return What prevents it, or nothing.
std::string cleared(const fs::path& folder, exchange::MissionFormat format) {
  std::error_code fault;
  fs::create_directories(folder, fault);
  for (const fs::path& earlier : earlier_missions(folder, format)) {
    if (!fs::remove(earlier, fault)) {
      return fmt::format("{}: an earlier export that cannot be removed", earlier.string());
    }
  }
  return {};
}

void warn_of_narrow_rows(const Missions& missions, const std::string& format) {
  const auto is_narrow = [](const exchange::TrackPoint& p) { return p.width > Length{}; };
  const bool has_any =
      std::any_of(missions.sorties.begin(), missions.sorties.end(), [&](const auto& track) {
        return std::any_of(track.points.begin(), track.points.end(), is_narrow);
      });
  if (!has_any) return;
  fmt::print(stderr,
             "furrow: warning: some rows are sprayed with a part of the boom; {} does not tell "
             "how wide (geojson and csv do)\n",
             format);
}

}  // namespace

int export_missions(const Options& options) {
  const auto format = exchange::mission_format(options.format);
  if (!format) {
    return refused(fmt::format(
        "--format: must be qgc-plan, waypoints, geojson, kml or csv (got {})", options.format));
  }
  const fs::path source = fs::path{options.folder} / "missions.json";
  std::ifstream in{source};
  const std::string json{std::istreambuf_iterator<char>{in}, {}};
  if (!in)
    return refused(fmt::format("{}: must be there: plan, sim or run writes it", source.string()));
  const auto missions = read_missions(json);
  if (!missions) return refused(fmt::format("{}: {}", source.string(), missions.error()));
  if (!missions->datum) {
    return refused(
        fmt::format("{}: the field has no place on the globe: give field.file or "
                    "field.datum in the scenario",
                    source.string()));
  }

  const fs::path target =
      options.out.empty() ? fs::path{options.folder} / "export" : fs::path{options.out};
  if (const std::string fault = cleared(target, *format); !fault.empty()) return refused(fault);
  if (!exchange::tells_width(*format)) warn_of_narrow_rows(*missions, options.format);
  const exchange::LocalFrame frame{*missions->datum};
  for (const exchange::SortieTrack& track : missions->sorties) {
    const fs::path path = target / exchange::file_name(track, *format);
    std::ofstream file{path, std::ios::binary};
    file << exchange::mission_file(track, frame, *format);
    if (!file.flush()) return refused(fmt::format("{}: cannot be written", path.string()));
  }
  if (!options.quiet) {
    fmt::print(stderr, "{} missions: {}\n", missions->sorties.size(), target.string());
  }
  return Exit::done;
}

}  // namespace furrow::app
