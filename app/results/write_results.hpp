#pragma once

#include "app/results/result.hpp"
#include "core/expected.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace furrow::app {

/// Why the results are not on disk.
struct WriteError {
  std::filesystem::path path;  ///< Of the file or folder at fault.
  std::string cause;
};

/// One line: the path and the cause.
std::string text(const WriteError& error);

/// Writes result.json, plan.geojson, missions.json, events.jsonl, sorties.csv and report.html into
/// `dir`, which is made where it is missing. Each file is written under a temporary name and then
/// renamed, all of them only when all are written: a crash leaves no half file.
///
/// @param result  The summary of `record`.
/// @return        The paths written.
Expected<std::vector<std::filesystem::path>, WriteError> write_results(
    const std::filesystem::path& dir, const MissionRecord& record, const Result& result);

}  // namespace furrow::app
