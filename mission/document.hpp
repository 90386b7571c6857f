#pragma once
// A YAML file as a tree that remembers its lines. Anchors and aliases are refused, and depth is
// bounded, so that no file can grow beyond its own size.

#include "core/expected.hpp"
#include "mission/load.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace furrow::mission {

/// A node of the tree: a scalar, a list or a map.
struct Element {
  enum class Kind { nothing, scalar, list, map };
  struct Key {
    std::string name;
    int line, column;
  };
  Kind kind;
  int line, column;  ///< From 1.
  std::string scalar;
  bool quoted;                 ///< A quoted scalar is text, whatever it looks like.
  std::vector<Key> keys;       ///< Of a map, one for each item, in file order.
  std::vector<Element> items;  ///< Of a list or a map.
};

/// The single document of `yaml`.
Expected<Element, ScenarioError> document(std::string_view yaml, const std::string& file);

/// What stands in a file, on one line and shortened: 3, "3", a list of 2, a map, nothing.
std::string shown(const Element& element);

/// Raw text made fit for one line of a message.
std::string shown(std::string_view raw);

}  // namespace furrow::mission
