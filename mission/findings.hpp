#pragma once

#include "mission/document.hpp"
#include "mission/load.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace furrow::mission {

/// What is wrong with a file, and which keys of it were asked for.
class Findings {
 public:
  /// @param survey  Collects every key asked for, whether the file has it or not; may be null.
  explicit Findings(std::string file, std::vector<KnownKey>* survey = nullptr)
      : file_{std::move(file)}, survey_{survey} {}

  void add(int line, int column, std::string key, std::string rule, std::string value);
  void ask(const Element* map, const std::string& path, std::string_view key, std::string rule,
           std::string otherwise);
  /// What is no error, but must be told: a sentence.
  void warn(int line, int column, std::string key, std::string sentence);
  /// Adds an error for every key that is unknown or given twice, in the maps that were read.
  void judge_keys();

  const std::string& file() const { return file_; }
  /// A path that the file names: relative to the file's folder.
  std::string beside(const std::string& path) const;
  bool is_survey() const { return survey_ != nullptr; }
  std::size_t count() const { return errors_.size(); }
  /// One line each, sorted as the errors.
  std::vector<std::string> warnings() const;
  /// Sorted by line, column and key.
  std::vector<ScenarioError> sorted() const;

 private:
  struct Asked {
    const Element* map;
    std::string path;
    std::vector<std::string> keys;
  };
  void judge(const Asked& asked);

  std::string file_;
  std::vector<KnownKey>* survey_;
  std::vector<ScenarioError> errors_, warnings_;
  std::vector<Asked> asked_;
  std::map<const Element*, std::size_t> index_;  // into asked_; never iterated
};

}  // namespace furrow::mission
