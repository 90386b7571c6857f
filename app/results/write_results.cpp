#include "app/results/write_results.hpp"

#include "app/exports/missions_json.hpp"
#include "app/exports/sortie_tracks.hpp"
#include "app/results/events_jsonl.hpp"
#include "app/results/plan_geojson.hpp"
#include "app/results/report/report_html.hpp"
#include "app/results/result_json.hpp"
#include "app/results/sorties_csv.hpp"

#include <cerrno>
#include <fstream>
#include <optional>
#include <system_error>
#include <utility>

namespace furrow::app {
namespace {

namespace fs = std::filesystem;

fs::path temporary(const fs::path& path) { return path.string() + ".part"; }

std::string last_cause() { return std::generic_category().message(errno ? errno : EIO); }

std::optional<WriteError> write(const fs::path& path, const std::string& content) {
  errno = 0;
  std::ofstream file{path, std::ios::binary | std::ios::trunc};
  if (!file) return WriteError{path, last_cause()};
  file.write(content.data(), static_cast<std::streamsize>(content.size()));
  file.close();
  if (!file) return WriteError{path, last_cause()};
  return {};
}

std::optional<Length> survey_height(const MissionRecord& record) {
  const auto& survey = record.scenario.survey;
  return survey ? std::optional{survey->height} : std::nullopt;
}

void remove(const std::vector<fs::path>& paths) {
  std::error_code ignored;  // they are leftovers of an error that is reported already
  for (const fs::path& path : paths) fs::remove(path, ignored);
}

}  // namespace

std::string text(const WriteError& error) { return error.path.string() + ": " + error.cause; }

Expected<std::vector<fs::path>, WriteError> write_results(const fs::path& dir,
                                                          const MissionRecord& record,
                                                          const Result& result) {
  std::error_code failed;
  fs::create_directories(dir, failed);
  if (failed) return Unexpected{WriteError{dir, failed.message()}};

  const std::pair<const char*, std::string> files[] = {
      {"result.json", result_json(result)},
      {"plan.geojson", plan_geojson(record)},
      {"missions.json",
       missions_json({record.scenario.datum, sortie_tracks(record.plan, survey_height(record))})},
      {"events.jsonl", events_jsonl(record.log)},
      {"sorties.csv", sorties_csv(result)},
      {"report.html", report_html(record, result)}};

  std::vector<fs::path> parts, paths;
  for (const auto& [file, content] : files) {
    paths.push_back(dir / file);
    parts.push_back(temporary(paths.back()));
    if (auto error = write(parts.back(), content)) {
      remove(parts);
      return Unexpected{std::move(*error)};
    }
  }
  for (std::size_t i = 0; i < paths.size(); ++i) {
    fs::rename(parts[i], paths[i], failed);
    if (failed) {
      remove(parts);
      return Unexpected{WriteError{paths[i], failed.message()}};
    }
  }
  return paths;
}

}  // namespace furrow::app
