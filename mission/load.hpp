#pragma once
// The door from scenario files to values.

#include "core/expected.hpp"
#include "mission/scenario.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace furrow::mission {

/// One broken rule of a scenario file.
struct ScenarioError {
  std::string file;
  int line, column;   ///< From 1; line 0 concerns the file as a whole.
  std::string key;    ///< Path of the key: "uavs[0].swath_m".
  std::string rule;   ///< As it should hold: "must be a number > 0 and <= 100".
  std::string value;  ///< What stands there instead, shortened.
};

/// "FILE:LINE: KEY: RULE (got VALUE)", always one line.
std::string text(const ScenarioError& error);

/// Reads and checks a scenario file of at most 1 MiB.
///
/// @return the scenario, or every broken rule, sorted by line. Never throws on bad input.
Expected<Scenario, std::vector<ScenarioError>> load(const std::string& path);

/// The same from text; `file` is named in the errors.
Expected<Scenario, std::vector<ScenarioError>> parse(std::string_view yaml,
                                                     const std::string& file);

/// A key that a scenario may have.
struct KnownKey {
  std::string path;       ///< List items without a number: "uavs[].swath_m".
  std::string rule;       ///< As in the errors.
  std::string otherwise;  ///< What holds when it is left out; "required" if it may not be.
};

/// Every key of the format, in the order in which it is read.
std::vector<KnownKey> known_keys();

}  // namespace furrow::mission
