#pragma once
// Reading a tree key by key. A reader carries its key path and line, so that a key of the format
// is one line of code, and what has been asked for is what is known.

#include "core/field.hpp"
#include "mission/document.hpp"
#include "mission/findings.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace furrow::mission {

/// The numbers that a key accepts.
struct Range {
  double low;
  bool low_open;
  double high;
  bool high_open;
};
constexpr Range from_to(double low, double high) { return {low, false, high, false}; }
constexpr Range above_to(double low, double high) { return {low, true, high, false}; }
constexpr Range from_below(double low, double high) { return {low, false, high, true}; }

/// One map of the file, or the absence of one: then every key takes its default.
///
/// A broken key is added to the findings and read as its default or some number in range. Keys
/// without a default are required.
class Section {
 public:
  static Section root(Findings& findings, const Element* map);

  double number(std::string_view key, Range range, std::optional<double> otherwise = {}) const;
  std::optional<double> optional_number(std::string_view key, Range range,
                                        const std::string& otherwise) const;
  std::uint64_t whole(std::string_view key, std::uint64_t low, std::uint64_t high,
                      std::optional<std::uint64_t> otherwise = {}) const;
  std::optional<std::uint64_t> optional_whole(std::string_view key, std::uint64_t low,
                                              std::uint64_t high,
                                              const std::string& otherwise) const;
  bool flag(std::string_view key, bool otherwise) const;
  std::optional<bool> optional_flag(std::string_view key, const std::string& otherwise) const;
  /// A word fit for file names.
  std::string name(std::string_view key) const;
  /// Any text on one line, 1 to 1000 bytes.
  std::optional<std::string> optional_text(std::string_view key,
                                           const std::string& otherwise) const;
  /// A key of the format that must be left out here.
  void refuse(std::string_view key, const std::string& rule) const;
  /// The index of the word chosen.
  std::size_t choice(std::string_view key, const std::vector<std::string>& words,
                     std::optional<std::size_t> otherwise = {}) const;
  FieldPoint point(std::string_view key) const;
  std::optional<FieldPoint> optional_point(std::string_view key,
                                           const std::string& otherwise) const;
  /// A repeated first vertex at the end is dropped. Empty if broken.
  Ring ring(std::string_view key) const;
  Ring optional_ring(std::string_view key, const std::string& otherwise) const;
  /// A ring for each item, in order; empty where broken.
  std::vector<Ring> rings(std::string_view key) const;

  Section section(std::string_view key) const;
  Section required_section(std::string_view key) const;
  /// The maps of a list; with `least` = 0 it may be left out. A survey gets one.
  std::vector<Section> list(std::string_view key, std::size_t least, std::size_t most) const;

  bool has(std::string_view key) const;
  /// Of this map: "uavs[0]".
  const std::string& path() const { return path_; }
  /// Adds an error at a key of this map, or at the map itself if it has no such key.
  /// @param key  May go on into a list: "holes_m[2]".
  void fail(std::string_view key, std::string rule, std::string value = {}) const;
  /// Adds a warning there; `sentence` is one line.
  void warn(std::string_view key, std::string sentence) const;
  Findings& findings() const { return *findings_; }

 private:
  struct Found {
    const Element* value;  // Null: not there, or nobody looks.
    int line, column;
    std::string path;
  };
  Section(Findings& findings, const Element* map, std::string path, int line, int column);
  std::string path_to(std::string_view key) const;
  Found find(std::string_view key) const;
  Found find_item(std::string_view key) const;
  // The same, known from now on; complains if it is required and missing.
  Found take(std::string_view key, const std::string& rule, const std::string& otherwise) const;
  void broken(const Found& found, const std::string& rule) const;
  Section child(std::string_view key, const std::string& otherwise) const;
  std::optional<FieldPoint> point_of(const Found& found) const;
  Ring ring_of(const Found& found) const;

  Findings* findings_;
  const Element* map_;  // Null for an absent or broken section.
  std::string path_;
  int line_, column_;
};

}  // namespace furrow::mission
