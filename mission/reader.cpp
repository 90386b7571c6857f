#include "mission/reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace furrow::mission {
namespace {

constexpr std::string_view required = "required";
constexpr double furthest_m = 100'000;
constexpr std::size_t most_vertices = 10'000, most_rings = 500;

template <class T>
std::optional<T> parsed(const Element& e) {
  if (e.kind != Element::Kind::scalar || e.quoted) return {};
  T value{};
  const char* end = e.scalar.data() + e.scalar.size();
  const auto [stop, fault] = std::from_chars(e.scalar.data(), end, value);
  if (fault != std::errc{} || stop != end) return {};
  return value;
}

bool holds(Range r, double v) {
  return std::isfinite(v) && (r.low_open ? v > r.low : v >= r.low) &&
         (r.high_open ? v < r.high : v <= r.high);
}

std::string rule_of(Range r) {
  return fmt::format("must be a number {} {:.10g} and {} {:.10g}", r.low_open ? ">" : ">=", r.low,
                     r.high_open ? "<" : "<=", r.high);
}

const std::string point_rule = fmt::format(
    "must be [east, north] in metres, each from {:.10g} to {:.10g}", -furthest_m, furthest_m);
const std::string ring_rule =
    fmt::format("must be a list of 3 to {} vertices [east, north]", most_vertices);
const std::string rings_rule = fmt::format("must be a list of at most {} rings", most_rings);
const std::string flag_rule = "must be true or false";
const std::string name_rule =
    "must be 1 to 64 of a-z A-Z 0-9 . _ - and begin with a letter or digit";

bool is_name(std::string_view s) {
  const auto alphanumeric = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
  };
  return !s.empty() && s.size() <= 64 && alphanumeric(s[0]) &&
         std::all_of(s.begin(), s.end(),
                     [&](char c) { return alphanumeric(c) || c == '.' || c == '_' || c == '-'; });
}

}  // namespace

Section::Section(Findings& findings, const Element* map, std::string path, int line, int column)
    : findings_{&findings}, map_{map}, path_{std::move(path)}, line_{line}, column_{column} {}

Section Section::root(Findings& findings, const Element* map) {
  if (map && map->kind != Element::Kind::map) {
    findings.add(map->line, map->column, "file", "must be a map of keys", shown(*map));
    map = nullptr;
  }
  return {findings, map, "", 1, 1};
}

std::string Section::path_to(std::string_view key) const {
  return path_.empty() ? std::string{key} : fmt::format("{}.{}", path_, key);
}

Section::Found Section::find(std::string_view key) const {
  for (std::size_t i = 0; map_ && i < map_->keys.size(); ++i) {
    const auto& k = map_->keys[i];
    if (k.name == key) return {&map_->items[i], k.line, k.column, path_to(key)};
  }
  return {nullptr, line_, column_, path_to(key)};
}

Section::Found Section::take(std::string_view key, const std::string& rule,
                             const std::string& otherwise) const {
  findings_->ask(map_, path_, key, rule, otherwise);
  Found found = find(key);
  if (map_ && !found.value && otherwise == required) {
    findings_->add(line_, column_, found.path, fmt::format("is required and {}", rule), "nothing");
  }
  return found;
}

void Section::broken(const Found& found, const std::string& rule) const {
  findings_->add(found.line, found.column, found.path, rule, shown(*found.value));
}

bool Section::has(std::string_view key) const { return find(key).value != nullptr; }

// As `find`, also for "holes_m[2]".
Section::Found Section::find_item(std::string_view key) const {
  const auto bracket = key.find('[');
  Found at = find(key.substr(0, bracket));
  at.path = path_to(key);
  std::size_t index = 0;
  if (at.value && bracket != std::string_view::npos &&
      std::from_chars(key.data() + bracket + 1, key.data() + key.size(), index).ec == std::errc{} &&
      index < at.value->items.size()) {
    at.value = &at.value->items[index];
    at.line = at.value->line;
    at.column = at.value->column;
  }
  return at;
}

void Section::fail(std::string_view key, std::string rule, std::string value) const {
  const Found at = find_item(key);
  if (value.empty()) value = at.value ? shown(*at.value) : "nothing";
  findings_->add(at.line, at.column, at.path, std::move(rule), std::move(value));
}

void Section::warn(std::string_view key, std::string sentence) const {
  const Found at = find_item(key);
  findings_->warn(at.line, at.column, at.path, std::move(sentence));
}

double Section::number(std::string_view key, Range range, std::optional<double> otherwise) const {
  const auto value = optional_number(
      key, range, otherwise ? fmt::format("{:.10g}", *otherwise) : std::string{required});
  return value.value_or(otherwise.value_or(range.high));
}

std::optional<double> Section::optional_number(std::string_view key, Range range,
                                               const std::string& otherwise) const {
  const auto rule = rule_of(range);
  const Found found = take(key, rule, otherwise);
  if (!found.value) return {};
  const auto value = parsed<double>(*found.value);
  if (value && holds(range, *value)) return value;
  broken(found, rule);
  return {};
}

std::uint64_t Section::whole(std::string_view key, std::uint64_t low, std::uint64_t high,
                             std::optional<std::uint64_t> otherwise) const {
  const auto value = optional_whole(
      key, low, high, otherwise ? fmt::format("{}", *otherwise) : std::string{required});
  return value.value_or(otherwise.value_or(low));
}

std::optional<std::uint64_t> Section::optional_whole(std::string_view key, std::uint64_t low,
                                                     std::uint64_t high,
                                                     const std::string& otherwise) const {
  const auto rule = low == high ? fmt::format("must be {}", low)
                                : fmt::format("must be a whole number from {} to {}", low, high);
  const Found found = take(key, rule, otherwise);
  if (!found.value) return {};
  const auto value = parsed<std::uint64_t>(*found.value);
  if (value && *value >= low && *value <= high) return value;
  broken(found, rule);
  return {};
}

bool Section::flag(std::string_view key, bool otherwise) const {
  return optional_flag(key, otherwise ? "true" : "false").value_or(otherwise);
}

std::optional<bool> Section::optional_flag(std::string_view key,
                                           const std::string& otherwise) const {
  const Found found = take(key, flag_rule, otherwise);
  if (!found.value) return {};
  if (found.value->kind == Element::Kind::scalar && !found.value->quoted) {
    if (found.value->scalar == "true") return true;
    if (found.value->scalar == "false") return false;
  }
  broken(found, flag_rule);
  return {};
}

std::optional<std::string> Section::optional_text(std::string_view key,
                                                  const std::string& otherwise) const {
  const std::string rule = "must be text of 1 to 1000 bytes on one line";
  const Found found = take(key, rule, otherwise);
  if (!found.value) return {};
  const Element& e = *found.value;
  const bool is_text = e.kind == Element::Kind::scalar && !e.scalar.empty() &&
                       e.scalar.size() <= 1000 &&
                       e.scalar.find_first_of(std::string_view{"\n\r\0", 3}) == std::string::npos;
  if (is_text) return e.scalar;
  broken(found, rule);
  return {};
}

void Section::refuse(std::string_view key, const std::string& rule) const {
  findings_->ask(map_, path_, key, rule, "left out");
  if (has(key)) fail(key, rule);
}

std::string Section::name(std::string_view key) const {
  const Found found = take(key, name_rule, std::string{required});
  if (!found.value) return {};
  if (found.value->kind == Element::Kind::scalar && is_name(found.value->scalar)) {
    return found.value->scalar;
  }
  broken(found, name_rule);
  return {};
}

std::size_t Section::choice(std::string_view key, const std::vector<std::string>& words,
                            std::optional<std::size_t> otherwise) const {
  const auto rule =
      fmt::format("must be {}{}", words.size() > 1 ? "one of " : "", fmt::join(words, ", "));
  const Found found = take(key, rule, otherwise ? words[*otherwise] : std::string{required});
  if (!found.value) return otherwise.value_or(0);
  const auto at = std::find(words.begin(), words.end(), found.value->scalar);
  if (found.value->kind == Element::Kind::scalar && at != words.end()) {
    return static_cast<std::size_t>(at - words.begin());
  }
  broken(found, rule);
  return otherwise.value_or(0);
}

std::optional<FieldPoint> Section::point_of(const Found& found) const {
  const Element& e = *found.value;
  if (e.kind == Element::Kind::list && e.items.size() == 2) {
    const auto x = parsed<double>(e.items[0]), y = parsed<double>(e.items[1]);
    const auto range = from_to(-furthest_m, furthest_m);
    if (x && y && holds(range, *x) && holds(range, *y)) return at_m(*x, *y);
    const auto broken_item = !(x && holds(range, *x)) ? 0u : 1u;
    findings_->add(found.line, found.column, found.path, point_rule, shown(e.items[broken_item]));
    return {};
  }
  broken(found, point_rule);
  return {};
}

FieldPoint Section::point(std::string_view key) const {
  return optional_point(key, std::string{required}).value_or(FieldPoint{});
}

std::optional<FieldPoint> Section::optional_point(std::string_view key,
                                                  const std::string& otherwise) const {
  const Found found = take(key, point_rule, otherwise);
  if (!found.value) return {};
  return point_of(found);
}

Ring Section::ring_of(const Found& found) const {
  const Element& e = *found.value;
  if (e.kind != Element::Kind::list || e.items.size() < 3 || e.items.size() > most_vertices) {
    broken(found, ring_rule);
    return {};
  }
  Ring ring;
  for (std::size_t i = 0; i < e.items.size(); ++i) {
    const auto& item = e.items[i];
    const auto path = fmt::format("{}[{}]", found.path, i);
    if (const auto p = point_of({&item, item.line, item.column, path})) ring.push_back(*p);
  }
  if (ring.size() < e.items.size()) return {};
  if (ring.size() > 3 && ring.front() == ring.back()) ring.pop_back();
  return ring;
}

Ring Section::ring(std::string_view key) const { return optional_ring(key, std::string{required}); }

Ring Section::optional_ring(std::string_view key, const std::string& otherwise) const {
  const Found found = take(key, ring_rule, otherwise);
  return found.value ? ring_of(found) : Ring{};
}

std::vector<Ring> Section::rings(std::string_view key) const {
  const Found found = take(key, rings_rule, "none");
  if (!found.value) return {};
  if (found.value->kind != Element::Kind::list || found.value->items.size() > most_rings) {
    broken(found, rings_rule);
    return {};
  }
  std::vector<Ring> rings;
  for (const auto& item : found.value->items) {
    const auto path = fmt::format("{}[{}]", found.path, rings.size());
    rings.push_back(ring_of({&item, item.line, item.column, path}));
  }
  return rings;
}

Section Section::child(std::string_view key, const std::string& otherwise) const {
  const Found found = take(key, "must be a map of keys", otherwise);
  const Element* map = found.value;
  if (map && map->kind != Element::Kind::map) {
    broken(found, "must be a map of keys");
    map = nullptr;
  }
  return {*findings_, map, found.path, found.line, found.column};
}

Section Section::section(std::string_view key) const { return child(key, "every default"); }

Section Section::required_section(std::string_view key) const {
  return child(key, std::string{required});
}

std::vector<Section> Section::list(std::string_view key, std::size_t least,
                                   std::size_t most) const {
  const auto rule = fmt::format("must be a list of {} to {} entries", least, most);
  const Found found = take(key, rule, least ? std::string{required} : "none");
  if (findings_->is_survey()) return {{*findings_, nullptr, found.path + "[]", 1, 1}};
  if (!found.value) return {};
  const Element& e = *found.value;
  const bool is_none = least == 0 && e.kind == Element::Kind::nothing;
  if (is_none) return {};
  if (e.kind != Element::Kind::list || e.items.size() < least || e.items.size() > most) {
    broken(found, rule);
    return {};
  }
  std::vector<Section> sections;
  for (const auto& item : e.items) {
    const auto path = fmt::format("{}[{}]", found.path, sections.size());
    const bool is_map = item.kind == Element::Kind::map;
    if (!is_map) findings_->add(item.line, item.column, path, "must be a map of keys", shown(item));
    sections.push_back({*findings_, is_map ? &item : nullptr, path, item.line, item.column});
  }
  return sections;
}

}  // namespace furrow::mission
