// Fields drawn by farmers, from the files that they come in. They are no part of the repository:
// the test is skipped where they are not.

#include "exchange/land.hpp"
#include "planner/coverage/mend.hpp"
#include "planner/coverage/swath/swath.hpp"
#include "tests/exchange/ground.hpp"
#include "tests/planner/coverage/swath/swath_test_support.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace {

using namespace furrow;
namespace fs = std::filesystem;

std::vector<std::string> field_files() {
  std::vector<std::string> files;
  for (const char* folder : {"../shared/data/fields", "../../shared/data/fields"}) {
    if (!files.empty() || !fs::is_directory(folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator{folder}) {
      if (entry.is_regular_file() && entry.path().extension() != ".md") {
        files.push_back(entry.path().string());
      }
    }
  }
  std::sort(files.begin(), files.end());
  if (files.empty()) WARN("skipped: no ../shared/data/fields");
  return files;
}

exchange::Land land(const std::string& file, std::size_t feature) {
  auto read = exchange::read_land(file, feature);
  INFO((read ? "" : text(read.error())));
  REQUIRE(read);
  auto sound = planner::sound_field(read->field);
  REQUIRE(sound);
  read->field = std::move(sound->field);
  return std::move(*read);
}

std::vector<exchange::Land> lands(const std::string& file) {
  std::vector<exchange::Land> all{land(file, 0)};
  while (all.size() < all.front().features) all.push_back(land(file, all.size()));
  return all;
}

TEST_CASE("real fields: each has the area that its file states") {
  std::size_t stated = 0;
  for (const std::string& file : field_files()) {
    for (const exchange::Land& read : lands(file)) {
      INFO(file << ", " << read.name);
      if (!read.stated_area) continue;
      ++stated;
      CHECK(exchange::ground::area_m2(read.field) ==
            Approx(read.stated_area->base()).epsilon(1e-3));
    }
  }
  CHECK((stated >= 6 || field_files().empty()));
}

TEST_CASE("real fields: rows cover each to the edge, or nothing beyond it") {
  for (const std::string& file : field_files()) {
    for (const exchange::Land& read : lands(file)) {
      for (const double swath_m : {2.0, 5.0, 12.0}) {
        INFO(file << ", " << read.name << ", swath " << swath_m << " m");
        const Length swath = metres(swath_m);
        const auto all = planner::swath_coverage(read.field, swath, {});
        REQUIRE(all);
        CHECK(planner::covered_share(*all) >= 0.999);

        planner::SwathSettings inside{.edges = planner::EdgeMode::stay_inside};
        inside.spray_margin = metres(0.1);  // five standard deviations of an RTK fix
        const auto kept = planner::swath_coverage(read.field, swath, inside);
        REQUIRE(kept);
        CHECK(kept->areas.outside == square_metres(0));
        CHECK(planner::outside_m(read.field, swath, *kept) == 0);
      }
    }
  }
}

}  // namespace
