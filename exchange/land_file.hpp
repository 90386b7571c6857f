#pragma once

#include "core/expected.hpp"

#include <map>
#include <string>

namespace furrow::exchange {

/// Why a file is no field.
struct LandError {
  std::string file;
  std::string rule;   ///< As it should hold: "must hold a polygon".
  std::string value;  ///< What is there instead, shortened.
};

/// "FILE: RULE (got VALUE)", always one line.
std::string text(const LandError& error);

/// A land file in memory, with the files that belong to it.
struct LandFile {
  std::string path;  ///< As in the errors.
  std::string bytes;
  /// Contents by name: "dbf", ... of a shapefile, "prj" also of a grid of heights, "PFD00001.XML",
  /// ... of an ISOXML task.
  std::map<std::string, std::string> companions = {};
};

/// Reads a regular file and its companions, together at most 64 MiB.
Expected<LandFile, LandError> land_file(const std::string& path);

}  // namespace furrow::exchange
