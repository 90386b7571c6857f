#include "planner/coverage/swath/swath.hpp"
#include "tests/planner/coverage/swath/swath_test_support.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <string>

using namespace furrow;
using namespace furrow::planner;

namespace {

// Rings of a GeoJSON polygon, each projected to a plane at the first vertex. Reads the numbers
// between the brackets after "coordinates" and nothing else of the format.
std::vector<Ring> rings_in(const std::string& text) {
  std::vector<Ring> rings;
  std::size_t i = text.find("\"coordinates\"");
  if (i == std::string::npos) return rings;
  double lon0 = 0, lat0 = 0;
  int depth = 0;
  std::vector<double> numbers;
  for (i = text.find('[', i); i < text.size(); ++i) {
    const char c = text[i];
    if (c == '[') {
      if (++depth == 2) rings.emplace_back();
      numbers.clear();
    } else if (c == ']') {
      if (depth == 3) {
        if (rings.size() == 1 && rings[0].empty()) lon0 = numbers[0], lat0 = numbers[1];
        constexpr double earth_m = 6'371'008.8, rad = std::numbers::pi / 180;
        rings.back().push_back(at_m((numbers[0] - lon0) * rad * earth_m * std::cos(lat0 * rad),
                                    (numbers[1] - lat0) * rad * earth_m));
      }
      if (--depth == 0) break;
    } else if (c == '-' || (c >= '0' && c <= '9')) {
      char* end = nullptr;
      numbers.push_back(std::strtod(text.c_str() + i, &end));
      i = static_cast<std::size_t>(end - text.c_str()) - 1;
    }
  }
  for (Ring& ring : rings) ring.pop_back();  // repeats the first
  return rings;
}

std::vector<std::filesystem::path> field_files() {
  std::vector<std::filesystem::path> files;
  for (const char* folder : {"data/fields", "../shared/data/fields", "../../shared/data/fields"}) {
    if (!std::filesystem::is_directory(folder)) continue;
    for (const auto& entry : std::filesystem::directory_iterator{folder}) {
      if (entry.path().extension() == ".geojson") files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

TEST_CASE("fields drawn by farmers are covered to the edge, or to nothing beyond it") {
  for (const auto& file : field_files()) {
    std::ifstream in{file};
    const std::vector<Ring> rings = rings_in({std::istreambuf_iterator<char>{in}, {}});
    REQUIRE(!rings.empty());
    const Field field{rings[0], {rings.begin() + 1, rings.end()}, {}};
    for (const double swath_m : {2.0, 5.0, 12.0}) {
      const Length swath = metres(swath_m);
      const auto all = swath_coverage(field, swath, {});
      INFO(file << ", swath " << swath_m << " m");
      REQUIRE(all);
      CHECK(covered_share(*all) >= 0.999);
      CHECK(outside_m(field, swath, *all) == 0);

      const auto inside = swath_coverage(field, swath, {.edges = EdgeMode::stay_inside});
      REQUIRE(inside);
      CHECK(inside->areas.outside.base() <= 1e-3);
      CHECK(outside_m(field, swath, *inside) == 0);
    }
  }
}
