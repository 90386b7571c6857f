// The scenarios that come with Furrow, the template as documentation, and mutations of it.

#include "core/random.hpp"
#include "mission/load.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

namespace furrow::mission {
namespace {

std::string content(const std::filesystem::path& path) {
  std::ostringstream out;
  out << std::ifstream{path}.rdbuf();
  return out.str();
}

Scenario loaded(const std::string& path) {
  const auto result = load(path);
  if (!result) FAIL(text(result.error().front()));
  return *result;
}

TEST_CASE("scenarios: every file in the folder loads", "[mission]") {
  for (const auto& entry : std::filesystem::directory_iterator{"scenarios"}) {
    if (entry.path().extension() == ".yaml") loaded(entry.path().string());
  }
}

TEST_CASE("scenarios: field A is the paper's", "[mission]") {
  const Scenario s = loaded("scenarios/wang2017_field_a_single.yaml");

  REQUIRE(s.uavs.size() == 1);
  CHECK(tank_range(s.uavs[0]) == metres(2700));
  CHECK(usable_endurance(s.uavs[0]) == seconds(1500));
  CHECK(s.uavs[0].home == *s.start);
  CHECK(s.stations.at(0).position == at_m(0, 0));
  CHECK(loaded("scenarios/wang2017_field_a.yaml").uavs.size() == 3);
  CHECK(loaded("scenarios/fleet_20.yaml").uavs.size() == 20);
}

// Path of each key of a file in block style -> its comment: the lines above it and beside it.
std::map<std::string, std::string> comments(const std::string& yaml) {
  std::map<std::string, std::string> found;
  std::vector<std::pair<std::size_t, std::string>> open;  // indent and path of the maps around
  std::string above;
  std::istringstream lines{yaml};
  for (std::string line; std::getline(lines, line);) {
    // A key that excludes another of the template is commented out.
    if (const auto mark = line.find("#~ "); mark != std::string::npos) line.erase(mark, 3);
    const bool is_item = line.find_first_not_of(' ') != std::string::npos &&
                         line.compare(line.find_first_not_of(' '), 2, "- ") == 0;
    if (is_item) line[line.find('-')] = ' ';
    const auto indent = line.find_first_not_of(' ');
    if (indent == std::string::npos) continue;
    if (is_item) {
      while (!open.empty() && open.back().first >= indent) open.pop_back();
      if (open.back().second.substr(open.back().second.size() - 2) != "[]") {
        open.back().second += "[]";
      }
    }
    if (line[indent] == '#') {
      above += line.substr(indent + 1);
      continue;
    }
    while (!open.empty() && open.back().first >= indent) open.pop_back();
    const auto colon = line.find(':');
    const auto key = line.substr(indent, colon - indent);
    const auto path = open.empty() ? key : open.back().second + "." + key;
    const auto beside = line.find(" # ");
    found.try_emplace(path, above + (beside == std::string::npos ? "" : line.substr(beside + 2)));
    open.emplace_back(indent, path);
    above.clear();
  }
  return found;
}

TEST_CASE("template: every known key stands there with its rule and default", "[mission]") {
  const auto found = comments(content("scenarios/template.yaml"));
  const std::string must_be = "must be ";
  for (const auto& key : known_keys()) {
    INFO(key.path);
    REQUIRE(found.count(key.path) == 1);
    const bool is_map = key.rule == "must be a map of keys";
    if (is_map) continue;
    const auto& comment = found.at(key.path);
    CHECK_THAT(comment, Catch::Contains(key.rule.substr(must_be.size())));
    CHECK_THAT(comment,
               Catch::EndsWith(key.otherwise == "required" ? "; required"
                                                           : "; default: " + key.otherwise));
  }
  CHECK(found.size() == known_keys().size());
}

// One to three random edits: a byte changed, a piece cut out, or a piece copied elsewhere.
std::string mutated(std::string yaml, Random& random) {
  static constexpr std::string_view bytes =
      "[]{}:,-#&*!|>'\"%@`?\n\t .0123456789eaxNIn\x00\xff\x7f";
  for (auto edits = 1 + random.below(3); edits > 0; --edits) {
    const auto at = random.below(yaml.size()), length = random.below(12);
    switch (random.below(3)) {
      case 0: yaml[at] = bytes[random.below(bytes.size())]; break;
      case 1: yaml.erase(at, length); break;
      case 2: yaml.insert(random.below(yaml.size()), yaml.substr(at, length)); break;
    }
  }
  return yaml;
}

TEST_CASE("template: a mutation of it loads or says why not, on one line each", "[mission]") {
  const std::string original = content("scenarios/template.yaml");
  std::string bare;  // Without comments, so that edits meet what counts.
  std::istringstream lines{original};
  for (std::string line; std::getline(lines, line);) {
    const auto text_end = line.find('#');
    const auto code = line.substr(0, text_end);
    const auto last = code.find_last_not_of(' ');
    if (last == std::string::npos) continue;
    bare += code.substr(0, last + 1) + "\n";
  }
  Random random{2017};
  int accepted = 0, refused = 0;
  for (int i = 0; i < 5'000; ++i) {
    const auto yaml = mutated(bare, random);
    const auto result = parse(yaml, "m.yaml");
    accepted += result.has_value();
    refused += !result.has_value();
    if (result) continue;
    REQUIRE_FALSE(result.error().empty());
    for (const auto& e : result.error()) REQUIRE(text(e).find('\n') == std::string::npos);
  }
  CHECK(accepted > 50);
  CHECK(refused > 1'000);
}

}  // namespace
}  // namespace furrow::mission
