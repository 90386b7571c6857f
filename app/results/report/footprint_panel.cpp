#include "app/results/report/footprint_panel.hpp"

#include "app/results/report/palette.hpp"
#include "app/results/report/simplify.hpp"
#include "app/results/report/view.hpp"
#include "app/results/sweep_coverage.hpp"

#include <algorithm>

namespace furrow::app {
namespace {

constexpr std::string_view sprayed = "#2f7fb5";
constexpr double tolerance = 0.25;  // pixels

void draw_runs(Svg& svg, const View& view, const std::vector<planner::BoomRun>& runs) {
  for (const planner::BoomRun& run : runs) {
    svg.path({simplified(pixels(view, run.path), tolerance)}, false,
             {.stroke = sprayed,
              .width = std::max(run.width.base() * view.pixels_per_m, 0.5),
              .opacity = 0.45});
  }
}

void draw_left_out(Svg& svg, const View& view, const MissionRecord& record,
                   const std::vector<std::vector<planner::FlownPlace>>& tracks) {
  const auto rings =
      planner::left_out(known_field(record), record.scenario.uavs.front().swath, tracks);
  if (!rings) return;  // the plan has judged the field
  std::vector<std::vector<Pixel>> chains;
  chains.reserve(rings->size());
  for (const Ring& ring : *rings) chains.push_back(pixels(view, ring));
  svg.path(chains, true, {.fill = alarm, .stroke = alarm, .width = 0.6});
}

void draw_seen(Svg& svg, const View& view, const MissionRecord& record) {
  for (const SeenObstacle& o : seen_obstacles(record.log)) {
    svg.circle(view.at(o.center), std::max(o.radius.base() * view.pixels_per_m, 2.0),
               {.fill = "#8d8d8d", .stroke = ink, .width = 1.6},
               fmt::format("met in flight at ({:.1f}, {:.1f}) m, radius {:.1f} m",
                           o.center.x.base(), o.center.y.base(), o.radius.base()));
  }
}

}  // namespace

std::string footprint_panel(const MissionRecord& record, const Flown* flown) {
  if (!record.plan.sweep || planner::is_survey(record.plan.route)) return "";
  const View view = view_of(record.scenario);
  Svg svg = land_panel(view, record.scenario, "Ground sprayed");
  const auto tracks = sprayed_tracks(record, flown);
  draw_runs(svg, view, planner::boom_runs(record.scenario.uavs.front().swath, tracks));
  draw_left_out(svg, view, record, tracks);
  draw_seen(svg, view, record);
  draw_stations(svg, view, record.scenario);
  return svg.markup();
}

std::string footprint_legend(const MissionRecord& record) {
  if (!record.plan.sweep || planner::is_survey(record.plan.route)) return "";
  const auto key = [](std::string_view colour, std::string_view words) {
    return fmt::format("<li><i class=\"key\" style=\"background:{}\"></i>{}</li>", colour, words);
  };
  const bool has_met = !seen_obstacles(record.log).empty();
  return "<ul class=\"legend\"><li class=\"head\">Ground sprayed</li>" + key("#9bbed0", "once") +
         key("#6aa1c4", "twice") + key(alarm, "left out") +
         (has_met ? "<li>grey, dark rim: obstacle met in flight</li>" : "") + "</ul>";
}

}  // namespace furrow::app
