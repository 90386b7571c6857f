#include "mission/document.hpp"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <sstream>

namespace furrow::mission {
namespace {

constexpr std::size_t max_depth = 16;

// Builds the tree from the parser's events; `stack` holds what is still open.
class TreeBuilder : public YAML::EventHandler {
 public:
  Element root{};

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    refuse_anchor(mark, anchor);
    attach(element(Element::Kind::nothing, mark));
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override { refuse_anchor(mark, 1); }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    refuse_anchor(mark, anchor);
    refuse_tag(mark, tag);
    Element scalar = element(Element::Kind::scalar, mark);
    scalar.scalar = value;
    scalar.quoted = tag == "!";
    attach(std::move(scalar));
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(Element::Kind::list, mark, tag, anchor);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(Element::Kind::map, mark, tag, anchor);
  }
  void OnMapEnd() override { close(); }

 private:
  static Element element(Element::Kind kind, const YAML::Mark& mark) {
    return {.kind = kind,
            .line = mark.line + 1,
            .column = mark.column + 1,
            .scalar = {},
            .quoted = false,
            .keys = {},
            .items = {}};
  }
  static void refuse_anchor(const YAML::Mark& mark, YAML::anchor_t anchor) {
    if (anchor) throw YAML::ParserException{mark, "anchors and aliases are not accepted"};
  }
  static void refuse_tag(const YAML::Mark& mark, const std::string& tag) {
    if (tag.size() > 1) throw YAML::ParserException{mark, "tags are not accepted"};
  }
  void open(Element::Kind kind, const YAML::Mark& mark, const std::string& tag,
            YAML::anchor_t anchor) {
    refuse_anchor(mark, anchor);
    refuse_tag(mark, tag);
    if (stack_.size() == max_depth) {
      throw YAML::ParserException{mark, fmt::format("at most {} levels are accepted", max_depth)};
    }
    if (expects_key()) throw YAML::ParserException{mark, "a key must be a word"};
    stack_.push_back(element(kind, mark));
  }
  void close() {
    Element done = std::move(stack_.back());
    stack_.pop_back();
    attach(std::move(done));
  }
  bool expects_key() const {
    return !stack_.empty() && stack_.back().kind == Element::Kind::map &&
           stack_.back().keys.size() == stack_.back().items.size();
  }
  void attach(Element element) {
    if (stack_.empty()) {
      root = std::move(element);
    } else if (expects_key()) {
      stack_.back().keys.push_back({std::move(element.scalar), element.line, element.column});
    } else {
      stack_.back().items.push_back(std::move(element));
    }
  }

  std::vector<Element> stack_;
};

// Line `number` of a text, from 1.
std::string_view line_of(std::string_view yaml, int number) {
  for (; number > 1; --number) {
    const auto end = yaml.find('\n');
    if (end == std::string_view::npos) return {};
    yaml.remove_prefix(end + 1);
  }
  return yaml.substr(0, yaml.find('\n'));
}

ScenarioError unreadable(std::string_view yaml, const std::string& file, int line, int column,
                         std::string_view why) {
  return {.file = file,
          .line = line,
          .column = column,
          .key = "yaml",
          .rule = fmt::format("must be a plain YAML document: {}", shown(why)),
          .value = shown(line_of(yaml, line))};
}

}  // namespace

std::string shown(std::string_view raw) {
  if (raw.empty()) return "nothing";
  constexpr std::size_t longest = 60;
  std::string line;
  for (const char c : raw.substr(0, longest)) {
    const auto byte = static_cast<unsigned char>(c);
    line += byte < 0x20 || byte == 0x7f ? fmt::format("\\x{:02x}", byte) : std::string(1, c);
  }
  return raw.size() > longest ? line + "..." : line;
}

std::string shown(const Element& element) {
  switch (element.kind) {
    case Element::Kind::nothing: return "nothing";
    case Element::Kind::scalar:
      return element.quoted ? fmt::format("\"{}\"", shown(element.scalar)) : shown(element.scalar);
    case Element::Kind::list: return fmt::format("a list of {}", element.items.size());
    case Element::Kind::map: return "a map";
  }
  return "nothing";
}

Expected<Element, ScenarioError> document(std::string_view yaml, const std::string& file) {
  std::istringstream in{std::string{yaml}};
  TreeBuilder tree, second;
  try {
    YAML::Parser parser{in};
    if (!parser.HandleNextDocument(tree)) {
      return Unexpected{unreadable(yaml, file, 1, 1, "it is empty")};
    }
    if (parser.HandleNextDocument(second)) {
      return Unexpected{unreadable(yaml, file, second.root.line, 1, "a file holds one document")};
    }
  } catch (const YAML::Exception& e) {
    return Unexpected{unreadable(yaml, file, std::max(e.mark.line + 1, 1),
                                 std::max(e.mark.column + 1, 1), e.msg)};
  }
  return std::move(tree.root);
}

}  // namespace furrow::mission
