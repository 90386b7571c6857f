#include "mission/findings.hpp"

#include "core/spelling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <tuple>

namespace furrow::mission {
namespace {

std::string nearest(std::string_view word, const std::vector<std::string>& known) {
  const auto shortened = word.substr(0, 100);
  return *std::min_element(known.begin(), known.end(), [&](const auto& a, const auto& b) {
    return edit_distance(shortened, a) < edit_distance(shortened, b);
  });
}

std::vector<ScenarioError> by_line(std::vector<ScenarioError> findings) {
  std::stable_sort(findings.begin(), findings.end(), [](const auto& a, const auto& b) {
    return std::tie(a.line, a.column, a.key) < std::tie(b.line, b.column, b.key);
  });
  return findings;
}

}  // namespace

void Findings::add(int line, int column, std::string key, std::string rule, std::string value) {
  errors_.push_back({file_, line, column, std::move(key), std::move(rule), std::move(value)});
}

void Findings::warn(int line, int column, std::string key, std::string sentence) {
  warnings_.push_back({file_, line, column, std::move(key), std::move(sentence), {}});
}

void Findings::ask(const Element* map, const std::string& path, std::string_view key,
                   std::string rule, std::string otherwise) {
  if (survey_) {
    survey_->push_back({path.empty() ? std::string{key} : fmt::format("{}.{}", path, key),
                        std::move(rule), std::move(otherwise)});
  }
  if (!map) return;
  const auto [at, is_new] = index_.try_emplace(map, asked_.size());
  if (is_new) asked_.push_back({map, path, {}});
  asked_[at->second].keys.emplace_back(key);
}

void Findings::judge_keys() {
  for (const auto& asked : asked_) judge(asked);
}

void Findings::judge(const Asked& asked) {
  std::map<std::string_view, int> first_line;
  for (std::size_t i = 0; i < asked.map->keys.size(); ++i) {
    const auto& key = asked.map->keys[i];
    const auto path =
        asked.path.empty() ? shown(key.name) : fmt::format("{}.{}", asked.path, shown(key.name));
    const auto value = shown(asked.map->items[i]);
    const auto [first, is_new] = first_line.try_emplace(key.name, key.line);
    if (!is_new) {
      add(key.line, key.column, path,
          fmt::format("must be given once, it is given on line {} too", first->second), value);
    } else if (std::find(asked.keys.begin(), asked.keys.end(), key.name) == asked.keys.end()) {
      add(key.line, key.column, path,
          fmt::format("must be a known key, the nearest is {}", nearest(key.name, asked.keys)),
          value);
    }
  }
}

std::string Findings::beside(const std::string& path) const {
  return (std::filesystem::path{file_}.parent_path() / path).string();
}

std::vector<ScenarioError> Findings::sorted() const { return by_line(errors_); }

std::vector<std::string> Findings::warnings() const {
  std::vector<std::string> lines;
  for (const auto& w : by_line(warnings_)) {
    lines.push_back(fmt::format("{}:{}: {}: warning: {}", shown(w.file), w.line, w.key, w.rule));
  }
  return lines;
}

}  // namespace furrow::mission
