#include "mission/load.hpp"

#include "mission/checks.hpp"
#include "mission/document.hpp"
#include "mission/schema.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <limits>

namespace furrow::mission {
namespace {

using Errors = std::vector<ScenarioError>;

constexpr std::size_t most_bytes = 1 << 20;

Unexpected<Errors> bad_file(const std::string& file, std::string rule, std::string value) {
  return {Errors{{file, 0, 0, "file", std::move(rule), std::move(value)}}};
}

// A UAV that is not told where it stands starts at the station nearest to where work begins.
void place_at_stations(Draft& draft) {
  auto& s = draft.scenario;
  const FieldPoint work = s.start.value_or(s.field.boundary.front());
  const Station* nearest = &s.stations.front();
  for (const auto& station : s.stations) {
    if (distance(station.position, work) < distance(nearest->position, work)) nearest = &station;
  }
  for (std::size_t i = 0; i < s.uavs.size(); ++i) {
    if (!draft.has_start[draft.fleet_of[i]]) s.uavs[i].home = nearest->position;
  }
}

// The line of every key below `element`.
void add_lines(const Element& element, const std::string& path, std::map<std::string, int>& lines) {
  const bool is_map = element.kind == Element::Kind::map;
  for (std::size_t i = 0; i < element.items.size(); ++i) {
    const Element& item = element.items[i];
    if (!is_map && item.kind != Element::Kind::map) continue;  // vertices, numbers
    const std::string below = !is_map        ? fmt::format("{}[{}]", path, i)
                              : path.empty() ? element.keys[i].name
                                             : path + "." + element.keys[i].name;
    lines[below] = is_map ? element.keys[i].line : item.line;
    add_lines(item, below, lines);
  }
}

Source source_of(const Draft& draft, const Element& tree, const std::string& file) {
  Source source{.file = file, .lines = {}, .stations = {}, .uavs = {}};
  add_lines(tree, {}, source.lines);
  for (const Section& station : draft.stations) source.stations.push_back(station.path());
  source.uavs.reserve(draft.fleet_of.size());
  for (const std::size_t fleet : draft.fleet_of) source.uavs.push_back(draft.fleets[fleet].path());
  return source;
}

}  // namespace

std::string text(const ScenarioError& e) {
  return fmt::format("{}:{}: {}: {} (got {})", shown(e.file), e.line, e.key, e.rule, e.value);
}

Expected<Scenario, Errors> parse(std::string_view yaml, const std::string& file) {
  if (yaml.size() > most_bytes) {
    return bad_file(file, "must hold at most 1 MiB", fmt::format("{} bytes", yaml.size()));
  }
  const auto tree = document(yaml, file);
  if (!tree) return Unexpected{Errors{tree.error()}};
  Findings findings{file};
  const Section root = Section::root(findings, &*tree);
  if (findings.count() > 0) return Unexpected{findings.sorted()};
  Draft draft = read_scenario(root);
  findings.judge_keys();
  check_together(root, draft);
  if (findings.count() > 0) return Unexpected{findings.sorted()};
  place_at_stations(draft);
  draft.scenario.source = source_of(draft, *tree, file);
  draft.scenario.warnings = findings.warnings();
  return std::move(draft.scenario);
}

Expected<Scenario, Errors> load(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code fault;
  const auto status = fs::status(path, fault);
  if (!fs::exists(status)) return bad_file(path, "must exist", "no such file");
  if (!fs::is_regular_file(status)) return bad_file(path, "must be a file", "something else");
  std::ifstream in{path, std::ios::binary};
  std::string yaml(most_bytes + 1, '\0');
  if (in) in.read(yaml.data(), static_cast<std::streamsize>(yaml.size()));
  if (!in.is_open() || in.bad()) return bad_file(path, "must be readable", "no access");
  yaml.resize(static_cast<std::size_t>(in.gcount()));
  if (yaml.size() > most_bytes) {
    return bad_file(path, "must hold at most 1 MiB",
                    fmt::format("{} bytes", fs::file_size(path, fault)));
  }
  return parse(yaml, path);
}

std::vector<KnownKey> known_keys() {
  std::vector<KnownKey> keys;
  Findings findings{"", &keys};
  read_scenario(Section::root(findings, nullptr));
  return keys;
}

}  // namespace furrow::mission
