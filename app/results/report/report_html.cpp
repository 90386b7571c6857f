#include "app/results/report/report_html.hpp"

#include "app/results/expectations.hpp"
#include "app/results/flown.hpp"
#include "app/results/report/charts.hpp"
#include "app/results/report/gantt.hpp"
#include "app/results/report/height_charts.hpp"
#include "app/results/report/map.hpp"
#include "app/results/report/page.hpp"
#include "app/results/report/svg.hpp"
#include "app/results/report/tables.hpp"

namespace furrow::app {
namespace {

std::string section(std::string_view heading, const std::string& content) {
  if (content.empty()) return {};
  return fmt::format("<section>\n<h2>{}</h2>\n{}</section>\n", escaped(heading), content);
}

std::string titled(std::string_view heading, const std::string& content) {
  if (content.empty()) return {};
  return fmt::format("<div><h3>{}</h3>\n{}</div>", escaped(heading), content);
}

std::string banner(const Result& r) {
  const bool is_bad = !r.completed || r.partial || !r.violations.empty() || !all_met(r);
  const std::string_view state = r.partial               ? "interrupted"
                                 : r.mode == Mode::plan  ? "plan"
                                 : !r.completed          ? "not completed"
                                 : !r.violations.empty() ? "completed, laws broken"
                                 : !all_met(r)           ? "completed, expectations missed"
                                                         : "completed";
  const std::string_view how = r.mode == Mode::plan  ? "Planned"
                               : r.mode == Mode::sim ? "Simulated mission"
                                                     : "Flown mission";
  return fmt::format(
      "<header><h1>{}</h1><p>{} · seed {} · {} UAV{} · {:.2f} ha</p><span class=\"badge "
      "{}\">{}</span>"
      "</header>\n",
      escaped(r.scenario), how, r.seed, r.uavs.size(), r.uavs.size() == 1 ? "" : "s",
      r.field.area_m2 / 10'000, is_bad ? "bad" : "", state);
}

std::string closing(const Result& r) {
  std::string words = "Planned in " + fmt::format("{:.2f} s", r.timing.plan_wall_s);
  if (r.timing.run_wall_s > 0) {
    words += fmt::format(", flown in {:.2f} s: {:.0f} times real time", r.timing.run_wall_s,
                         r.real_time_factor);
  }
  return fmt::format("<footer>Furrow. {}. Log of {} messages, digest {}.</footer>\n", words,
                     r.log.messages, r.log.digest);
}

}  // namespace

std::string report_html(const MissionRecord& record, const Result& result) {
  const Flown log = flown(record);
  const Colours colours = uav_colours(record.plan.route, record.plan.uavs);
  std::string page = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
      "<title>{} - Furrow</title>\n<style>{}</style>\n</head>\n<body>\n",
      escaped(result.scenario), page_style);
  page += banner(result);
  page += section("At a glance",
                  headline(result) + titled("What was expected", expectation_table(result)));
  page += section("Map", map_figure(record, log, result, colours));
  page += section("Over the ground", height_charts(record, log, colours));
  page += section("What was covered", coverage_table(result));
  page += section("Who did what when", gantt_figure(log, result, colours));
  page += section("The plan against the optimum", optimum_table(result) + uav_table(result));
  if (!result.survey)
    page +=
        section("Off the line", deviation_table(result) + deviation_charts(record, log, colours));
  page += section("Worth reading", event_table(record));
  page += section("Stations and batteries",
                  "<div class=\"two\">" + titled("Stations", station_table(result)) +
                      titled("Batteries", battery_table(result)) + "</div>");
  page += section("Sorties", sortie_table(result));
  page += section("Scenario", scenario_table(record));
  return page + closing(result) + "</body>\n</html>\n";
}

}  // namespace furrow::app
