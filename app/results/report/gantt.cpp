#include "app/results/report/gantt.hpp"

#include "app/results/report/palette.hpp"
#include "app/results/report/svg.hpp"
#include "app/results/report/timeline.hpp"
#include "app/results/report/view.hpp"

#include <algorithm>
#include <optional>

namespace furrow::app {
namespace {

constexpr double width = 1070, label_width = 92, right_margin = 14;
constexpr double top = 34, bottom = 22;
constexpr std::size_t rows_per_picture = 40;  // a page's worth

struct Bar {
  double from_s, to_s;
  std::string_view colour;
  double share;  ///< Of the row's height.
  double opacity;
  std::string tip, label;
};

struct Row {
  std::string label;
  std::vector<Bar> bars;
  std::optional<double> planned_end_s, lost_s;
  std::optional<double> opens_s{}, closes_s{};  ///< Of a bay that serves nobody else.
};

std::string_view words(Phase phase) {
  switch (phase) {
    case Phase::idle: return "idle";
    case Phase::fly_out: return "flying out";
    case Phase::spray: return "spraying";
    case Phase::hold: return "hovering";
    case Phase::fly_back: return "flying back";
    case Phase::wait: return "waiting for a bay";
    case Phase::service: return "in a bay";
    case Phase::done: return "done";
    case Phase::offline: return "offline";
  }
  return "unknown";
}

std::optional<Bar> bar(const Span& span, std::string_view colour) {
  Bar b{span.from_s, span.to_s, colour, 0.9, 1, {}, {}};
  switch (span.phase) {
    case Phase::spray: break;
    case Phase::fly_out:
    case Phase::fly_back:
      b.share = 0.42;
      b.opacity = 0.55;
      break;
    case Phase::hold: b.colour = alarm; break;
    case Phase::wait: b.colour = waiting; break;
    case Phase::service: b.colour = serving; break;
    default: return {};
  }
  b.tip =
      fmt::format("{}: {:.1f} to {:.1f} min", words(span.phase), span.from_s / 60, span.to_s / 60);
  return b;
}

std::vector<Row> uav_rows(const Flown& flown, const Result& result, const Colours& colours) {
  const auto spans = timelines(result, flown);
  std::vector<Row> rows;
  for (std::size_t i = 0; i < result.uavs.size(); ++i) {
    Row row{.label = fmt::format("UAV {}", result.uavs[i].id),
            .bars = {},
            .planned_end_s = {},
            .lost_s = {}};
    for (const Span& span : spans[i]) {
      if (auto b = bar(span, colours[i]); b && b->to_s > b->from_s)
        row.bars.push_back(std::move(*b));
    }
    if (result.uavs[i].planned_spray_ended_s > 0) {
      row.planned_end_s = result.uavs[i].planned_spray_ended_s;
    }
    if (result.uavs[i].lost && !spans[i].empty()) row.lost_s = spans[i].back().to_s;
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<Row> bay_rows(const Result& result, const Colours& colours) {
  std::vector<Row> rows;
  for (const StationFigures& station : result.stations) {
    for (const BayFigures& bay : station.bays) {
      Row row{.label = fmt::format("Station {} bay {}", station.id, bay.bay),
              .bars = {},
              .planned_end_s = {},
              .lost_s = {},
              .opens_s = station.available_from_s,
              .closes_s = station.available_until_s};
      for (std::size_t i = 0; i < result.uavs.size(); ++i) {
        for (const SortieFigures& s : result.uavs[i].sorties) {
          if (s.station != station.id || s.bay != bay.bay) continue;
          row.bars.push_back({s.service_began_s, s.ready_s, colours[i], 0.9, 1,
                              fmt::format("UAV {}: {:.1f} to {:.1f} min", result.uavs[i].id,
                                          s.service_began_s / 60, s.ready_s / 60),
                              fmt::format("{}", result.uavs[i].id)});
        }
      }
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

struct Scale {
  double end_s, row_height;
  double x(double t_s) const {
    return label_width + t_s / end_s * (width - label_width - right_margin);
  }
};

void draw_axis(Svg& svg, const Scale& scale, double height) {
  const double step_min = round_step(scale.end_s / 60 / 8);
  for (double t_min = 0; t_min * 60 <= scale.end_s; t_min += step_min) {
    const double x = scale.x(t_min * 60);
    svg.line({x, top - 4}, {x, height - bottom + 3}, {.stroke = rule_line});
    svg.text({x, height - bottom + 15}, fmt::format("{:g}", t_min),
             {.size = 10, .anchor = "middle", .fill = faint_ink});
  }
  svg.text({6, height - bottom + 15}, "minutes", {.size = 10, .fill = faint_ink});
}

// The time in which a bay serves nobody.
void draw_closed(Svg& svg, const Scale& scale, double from_s, double to_s, double y) {
  if (from_s >= std::min(to_s, scale.end_s)) return;
  const double x = scale.x(from_s);
  svg.rect({x, y}, scale.x(std::min(to_s, scale.end_s)) - x, scale.row_height - 2,
           {.fill = rule_line, .opacity = 0.6}, 0, "closed");
}

void draw_row(Svg& svg, const Scale& scale, const Row& row, double y) {
  const double height = scale.row_height;
  svg.text({6, y + height / 2 + 4}, row.label, {.size = 11, .fill = ink});
  draw_closed(svg, scale, 0, row.opens_s.value_or(0), y);
  if (row.closes_s) draw_closed(svg, scale, *row.closes_s, scale.end_s, y);
  for (const Bar& b : row.bars) {
    const double x = scale.x(b.from_s), wide = std::max(scale.x(b.to_s) - x, 0.6);
    const double tall = (height - 3) * b.share;
    svg.rect({x, y + (height - tall) / 2}, wide, tall, {.fill = b.colour, .opacity = b.opacity}, 0,
             b.tip);
    if (!b.label.empty() && wide > 7.0 * static_cast<double>(b.label.size())) {
      svg.text({x + wide / 2, y + height / 2 + 3.5}, b.label,
               {.size = 9.5, .anchor = "middle", .fill = ink, .bold = true, .halo = true});
    }
  }
  const double middle = y + height / 2;
  if (row.planned_end_s) {
    const double x = scale.x(*row.planned_end_s);
    svg.path({{{x, middle - 5}, {x + 4, middle}, {x, middle + 5}, {x - 4, middle}}}, true,
             {.fill = "#fff", .stroke = ink, .width = 1.2});
  }
  if (row.lost_s) {
    const double x = scale.x(*row.lost_s);
    svg.path(
        {{{x - 4, middle - 5}, {x + 4, middle + 5}}, {{x - 4, middle + 5}, {x + 4, middle - 5}}},
        false, {.stroke = alarm, .width = 2.4});
    svg.text({x + 8, middle + 4}, "lost", {.size = 11, .fill = alarm, .bold = true});
  }
}

void draw_mark(Svg& svg, const Scale& scale, double height, double t_s, std::string_view label,
               std::string_view anchor, double y, std::string_view dash) {
  if (t_s <= 0) return;
  const double x = scale.x(t_s);
  svg.line({x, y + 3}, {x, height - bottom}, {.stroke = ink, .width = 1.1, .dash = dash});
  const double shift = anchor == "end" ? -3 : 3;
  svg.text({x + shift, y + 9}, label, {.size = 10, .anchor = anchor, .fill = ink, .halo = true});
}

std::string picture(const std::vector<Row>& rows, const Scale& scale, const FleetFigures& fleet,
                    bool is_flown) {
  const double height = top + scale.row_height * static_cast<double>(rows.size()) + bottom;
  Svg svg{width, height, "Who did what when"};
  draw_axis(svg, scale, height);
  double y = top;
  for (const Row& row : rows) {
    draw_row(svg, scale, row, y);
    y += scale.row_height;
  }
  if (fleet.lower_bound_s > 0)
    draw_mark(svg, scale, height, fleet.lower_bound_s, "no plan ends earlier", "end", 0, "2 3");
  draw_mark(
      svg, scale, height, fleet.makespan_s,
      fmt::format("work {} {:.1f}", is_flown ? "ended" : "planned to end", fleet.makespan_s / 60),
      "end", 13, "");
  return svg.markup();
}

std::string legend(bool is_survey, bool closes) {
  const auto key = [](std::string_view style, std::string_view words) {
    return fmt::format("<li><i class=\"key\" style=\"{}\"></i>{}</li>", style, words);
  };
  return "<ul class=\"legend\">" +
         key("background:#0072b2",
             is_survey ? "visiting (the UAV's colour)" : "spraying (the UAV's colour)") +
         key("background:#0072b2;opacity:.55;height:5px", "flying out or back") +
         key(fmt::format("background:{}", waiting), "waiting for a bay") +
         key(fmt::format("background:{}", serving), "in a bay") +
         (closes ? key(fmt::format("background:{}", rule_line), "station closed") : "") +
         key(fmt::format("background:{}", alarm), "hovering: no grant, no clear way, or paused") +
         "<li><i class=\"key diamond\"></i>planned end of work</li></ul>";
}

}  // namespace

std::string gantt_figure(const Flown& flown, const Result& result, const Colours& colours) {
  std::vector<Row> rows = uav_rows(flown, result, colours);
  for (Row& row : bay_rows(result, colours)) rows.push_back(std::move(row));
  double end_s = std::max({result.fleet.makespan_s, result.fleet.planned_makespan_s, 60.0});
  for (const Row& row : rows) {
    for (const Bar& b : row.bars) end_s = std::max(end_s, b.to_s);
  }
  const Scale scale{end_s * 1.01, rows.size() > 30 ? 15.0 : 22.0};
  std::string figure;
  for (std::size_t first = 0; first < rows.size(); first += rows_per_picture) {
    const auto begin = rows.begin() + static_cast<std::ptrdiff_t>(first);
    const auto count = std::min(rows_per_picture, rows.size() - first);
    figure += picture({begin, begin + static_cast<std::ptrdiff_t>(count)}, scale, result.fleet,
                      result.mode != Mode::plan);
  }
  const bool closes = std::any_of(rows.begin(), rows.end(), [](const Row& r) {
    return r.opens_s.value_or(0) > 0 || r.closes_s;
  });
  return figure + legend(result.survey.has_value(), closes);
}

}  // namespace furrow::app
