#include "app/exports/missions_json.hpp"
#include "app/exports/sortie_tracks.hpp"
#include "app/options.hpp"
#include "tests/app/results/small_mission.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <set>
#include <unistd.h>

namespace furrow::app {
namespace {

namespace fs = std::filesystem;

std::set<std::string> names(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator{folder}) names.insert(entry.path().filename());
  return names;
}

TEST_CASE("Exporting again leaves no mission of an earlier export, and other files alone",
          "[app]") {
  const fs::path folder = fs::temp_directory_path() / ("furrow_export_" + std::to_string(getpid()));
  const fs::path target = folder / "export";
  fs::create_directories(target);
  std::ofstream{folder / "missions.json"}
      << missions_json({exchange::Datum{51.5, 4.25}, sortie_tracks(small_plan().plan)});
  for (const char* name : {"uav9_sortie1.csv", "uav9_sortie1.kml", "notes.csv"}) {
    std::ofstream{target / name} << "there before";
  }
  Options options;
  options.folder = folder.string();
  options.format = "csv";
  options.quiet = true;

  CHECK(export_missions(options) == Exit::done);

  CHECK(names(target) == std::set<std::string>{"notes.csv", "uav1_sortie1.csv", "uav1_sortie2.csv",
                                               "uav2_sortie1.csv", "uav9_sortie1.kml"});
  fs::remove_all(folder);
}

}  // namespace
}  // namespace furrow::app
