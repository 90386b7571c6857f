// Each file in broken/ says exactly what its .expected says.

#include "mission/load.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace furrow::mission {
namespace {

std::string content(const std::filesystem::path& path) {
  std::ostringstream out;
  out << std::ifstream{path}.rdbuf();
  return out.str();
}

TEST_CASE("broken scenarios: every error has its line, key, rule and value", "[mission]") {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator{"tests/mission/broken"}) {
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  REQUIRE(files.size() >= 45);

  for (auto file : files) {
    INFO(file);
    const auto result = load(file.string());
    REQUIRE_FALSE(result);
    std::string lines;
    for (const auto& e : result.error()) lines += text(e) + "\n";
    CHECK(lines == content(file.replace_extension(".expected")));
  }
}

}  // namespace
}  // namespace furrow::mission
