#include "exchange/land_file.hpp"

#include "exchange/gdal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>

namespace furrow::exchange {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t largest_bytes = std::uintmax_t{64} << 20;

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::optional<std::string> contents(const fs::path& path, std::uintmax_t most) {
  std::error_code none;
  const auto size = fs::file_size(path, none);
  if (none || size > most) return std::nullopt;
  std::ifstream in{path, std::ios::binary};
  std::string bytes(size, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(size));
  if (!in) return std::nullopt;
  return bytes;
}

// A part of a shapefile, the CRS of a shapefile or a grid of heights, or an external file of an
// ISOXML task: the name under which it is kept.
std::optional<std::string> companion_name(const fs::path& main, const fs::path& other,
                                          bool has_references) {
  const std::string name = other.filename().string();
  const std::string extension = lower(other.extension().string());
  if (other.stem() == main.stem() && extension == ".prj") return "prj";
  const bool is_shapefile = lower(main.extension().string()) == ".shp";
  for (const std::string_view part : {".shx", ".dbf", ".cpg"}) {
    if (is_shapefile && other.stem() == main.stem() && extension == part)
      return extension.substr(1);
  }
  const bool is_part_field = lower(name).starts_with("pfd") && extension == ".xml";
  if (has_references && is_part_field) return name;
  return std::nullopt;
}

LandError too_large(const std::string& path, std::uintmax_t size) {
  return {path, "must be at most 64 MiB together with its companions",
          fmt::format("{} MiB", size >> 20)};
}

}  // namespace

std::string text(const LandError& error) {
  return fmt::format("{}: {} (got {})", shown(error.file), error.rule, error.value);
}

Expected<LandFile, LandError> land_file(const std::string& path) {
  std::error_code none;
  const fs::path main{path};
  if (!fs::is_regular_file(main, none)) {
    return Unexpected{LandError{path, "must be a readable file",
                                fs::exists(main, none) ? "something else" : "nothing"}};
  }
  std::uintmax_t total = fs::file_size(main, none);
  if (!none && total > largest_bytes) return Unexpected{too_large(path, total)};
  auto bytes = contents(main, largest_bytes);
  if (!bytes) return Unexpected{LandError{path, "must be a readable file", "no permission"}};
  LandFile file{.path = path, .bytes = std::move(*bytes)};

  const bool has_references = file.bytes.find("<XFR") != std::string::npos;
  const fs::path folder = main.has_parent_path() ? main.parent_path() : fs::path{"."};
  for (auto entry = fs::directory_iterator{folder, none};
       !none && entry != fs::directory_iterator{}; entry.increment(none)) {
    const auto name = companion_name(main, entry->path(), has_references);
    if (!name || !entry->is_regular_file(none)) continue;
    auto part = contents(entry->path(), largest_bytes - std::min(total, largest_bytes));
    if (!part) return Unexpected{too_large(path, total + entry->file_size(none))};
    total += part->size();
    file.companions.emplace(*name, std::move(*part));
  }
  return file;
}

}  // namespace furrow::exchange
