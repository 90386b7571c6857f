#include "app/results/report/html_table.hpp"
#include "app/results/report/tables.hpp"

#include <algorithm>
#include <set>
#include <tuple>

namespace furrow::app {
namespace {

constexpr std::size_t most_lines = 150;

struct Line {
  Instant at;
  std::string from, what, detail;
  bool is_bad;
};

bool is_routine(const Event& event) { return event.kind.starts_with("sortie_"); }

// The words of the log that are worth reading. Reports repeat their closures; one line each.
std::vector<Line> lines(const MissionRecord& record) {
  std::vector<Line> all;
  std::set<std::tuple<AgentId, Epoch, std::uint64_t>> told;
  for (const Envelope& e : record.log) {
    if (const auto* event = std::get_if<Event>(&e.body); event && !is_routine(*event)) {
      const bool is_bad = event->kind.ends_with("_lost") || event->kind.ends_with("_abandoned") ||
                          event->kind.ends_with("_uncertain") || event->kind == "mission_limit";
      all.push_back({e.sent, text(e.from), event->kind, event->detail, is_bad});
    }
    const auto* report = std::get_if<WorkReport>(&e.body);
    if (!report) continue;
    for (const Closure& c : report->closures) {
      if (c.reason == CloseReason::sprayed) continue;
      if (!told.insert({report->agent, report->epoch, c.grant}).second) continue;
      const std::string_view why = c.reason == CloseReason::tank_low      ? "tank low"
                                   : c.reason == CloseReason::battery_low ? "battery low"
                                   : c.reason == CloseReason::strayed     ? "strayed from its line"
                                   : c.reason == CloseReason::blocked     ? "blocked by an obstacle"
                                   : c.reason == CloseReason::recalled    ? "called home"
                                                                          : "a newer order came";
      all.push_back({c.at, text(e.from), "closed_early",
                     fmt::format("grant {}: {} of {} cells sprayed, {}", c.grant, c.sprayed,
                                 c.cells.count, why),
                     false});
    }
  }
  for (const Violation& v : record.violations) {
    all.push_back({v.at, "checkers", "law " + v.law + " broken", v.detail, true});
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Line& a, const Line& b) { return a.at < b.at; });
  return all;
}

}  // namespace

std::string event_table(const MissionRecord& record) {
  std::vector<Line> all = lines(record);
  const std::size_t count = all.size();
  if (count > most_lines) {
    // The bad first: they are what a reader looks for.
    std::stable_partition(all.begin(), all.end(), [](const Line& line) { return line.is_bad; });
    all.resize(most_lines);
  }
  HtmlTable table{"At, min", "<From", "<What", "<Detail"};
  for (const Line& line : all) {
    table.row(
        {fmt::format("{:.2f}", seconds(line.at).base() / 60), line.from, line.what, line.detail},
        line.is_bad ? "bad" : "");
  }
  if (table.empty()) return {};
  const std::string rest =
      count > most_lines
          ? fmt::format("<p class=\"note\">and {} more in events.jsonl</p>", count - most_lines)
          : "";
  return table.markup() + rest;
}

}  // namespace furrow::app
