#include "app/results/report/map.hpp"

#include "app/results/report/footprint_panel.hpp"
#include "app/results/report/height_charts.hpp"
#include "app/results/report/palette.hpp"
#include "app/results/report/simplify.hpp"
#include "app/results/report/view.hpp"

#include <algorithm>

namespace furrow::app {
namespace {

using Chains = std::vector<std::vector<Pixel>>;

class Panels {
 public:
  Panels(const MissionRecord& record, const Flown& flown, const Result& result,
         const Colours& colours)
      : record_{record},
        route_{record.plan.route},
        flown_{flown},
        result_{result},
        colours_{colours},
        view_{view_of(record.scenario)} {}

  std::string planned() const {
    Svg svg = land_panel(view_, record_.scenario, "Planned");
    draw_relief(svg);
    for (std::size_t i = 0; i < uavs().size(); ++i) draw_ferries(svg, i);
    for (std::size_t i = 0; i < uavs().size(); ++i) {
      svg.path(strips(i), false,
               {.stroke = colours_[i], .width = line_width(0.62), .opacity = 0.9});
      draw_visits(svg, i);
    }
    draw_cells(svg, route_.missed, alarm);
    for (std::size_t i = 0; i < uavs().size(); ++i) draw_returns(svg, i);
    draw_labels(svg);
    draw_stations(svg, view_, record_.scenario);
    return svg.markup();
  }

  std::string tracks() const {
    Svg svg = land_panel(view_, record_.scenario, "Flown");
    draw_relief(svg);
    for (std::size_t i = 0; i < uavs().size(); ++i) {
      svg.path(strips(i), false, {.stroke = "#a9a48f", .width = 0.6});
      draw_visits(svg, i);
    }
    for (const bool spraying : {false, true}) {
      for (std::size_t i = 0; i < flown_.uavs.size(); ++i) {
        svg.path(track(flown_.uavs[i].track, spraying), false,
                 {.stroke = spraying || planner::is_survey(route_) ? colours_[i] : "#4a4a44",
                  .width = spraying ? line_width(0.42) : 0.6,
                  .opacity = spraying || planner::is_survey(route_) ? 1 : 0.55});
      }
    }
    for (std::size_t i = 0; i < result_.uavs.size(); ++i) draw_landings(svg, i);
    draw_stations(svg, view_, record_.scenario);
    for (std::size_t i = 0; i < result_.uavs.size(); ++i) draw_loss(svg, i);
    return svg.markup();
  }

  std::string accuracy() const {
    Svg svg = land_panel(view_, record_.scenario, "Off the line");
    draw_offsets(svg);
    draw_cells(svg, route_.missed, alarm);
    draw_chosen(
        svg, [&](std::uint32_t i) { return flown_.proofs[i] == 0; }, alarm);
    std::vector<std::uint32_t> passes(flown_.proofs.size());
    for (const Pass& pass : flown_.passes) ++passes[pass.cell];
    draw_chosen(
        svg, [&](std::uint32_t i) { return passes[i] > 1; }, "#6a3d9a");
    draw_stations(svg, view_, record_.scenario);
    return svg.markup();
  }

 private:
  const std::vector<scheduler::UavPlan>& uavs() const { return record_.plan.uavs; }
  double line_width(double share) const {
    return std::clamp(route_.cell.base() * view_.pixels_per_m * share, 0.7, 5.0);
  }

  Chains strips(std::size_t uav) const {
    Chains chains;
    const CellRange share = uavs()[uav].strips;
    const double half = route_.cell.base() * view_.pixels_per_m / 2;
    for (std::uint32_t i = share.first; i < end(share); ++i) {
      const planner::Strip& strip = route_.strips[i];
      const Pixel a = view_.at(strip.begin), b = view_.at(strip.end);
      if (planner::sprays_ends(strip)) {
        chains.push_back({a, b});
        continue;
      }
      // To the rims of the end cells; a strip of one cell is still seen.
      const double length = std::hypot(b.x - a.x, b.y - a.y);
      const double dx = length > 0 ? (b.x - a.x) / length * half : 0;
      const double dy = length > 0 ? (b.y - a.y) / length * half : half;
      chains.push_back({{a.x - dx, a.y - dy}, {b.x + dx, b.y + dy}});
    }
    return chains;
  }

  // Of a survey: its way points, and the ways between them.
  void draw_visits(Svg& svg, std::size_t uav) const {
    if (!planner::is_survey(route_)) return;
    const CellRange share = uavs()[uav].strips;
    Chains ways;
    for (std::uint32_t i = share.first + 1; i < end(share); ++i) {
      std::vector<FieldPoint> way{route_.strips[i - 1].end};
      way.insert(way.end(), route_.strips[i].approach.begin(), route_.strips[i].approach.end());
      way.push_back(route_.strips[i].begin);
      ways.push_back(pixels(view_, way));
    }
    svg.path(ways, false, {.stroke = colours_[uav], .width = 1.2, .opacity = 0.6});
    for (std::uint32_t i = share.first; i < end(share); ++i) {
      const FieldPoint at = route_.strips[i].begin;
      svg.circle(
          view_.at(at), 3.4, {.fill = colours_[uav], .stroke = ink, .width = 0.8},
          fmt::format("way point {} at ({:.1f}, {:.1f}) m", i + 1, at.x.base(), at.y.base()));
    }
  }

  FieldPoint stop_after(std::uint32_t cell) const {
    return planner::stop_point(route_, route_.strips[planner::strip_of(route_, cell)], cell);
  }

  void draw_ferries(Svg& svg, std::size_t uav) const {
    const scheduler::UavPlan& plan = uavs()[uav];
    Chains ways;
    std::size_t sortie = 0;
    for (const std::uint32_t cell : plan.solution.plan.returns) {
      const FieldPoint station = scheduler::landing(plan, sortie++).position;
      const FieldPoint stop = stop_after(plan.cells.first + cell);
      ways.push_back(pixels(view_, route_.ferries.ferry_way(stop, station, plan.vehicle)));
    }
    svg.path(ways, false, {.stroke = "#8b8b80", .width = 0.6, .opacity = 0.7, .dash = "3 3"});
  }

  // The ground from the field to its stations, and the volumes that nobody enters.
  void draw_relief(Svg& svg) const {
    const planner::Relief* relief = route_.ferries.relief();
    if (relief == nullptr) return;
    draw_contours(svg, *relief);
    for (const planner::KeepOut& volume : relief->keep_out()) {
      const FieldPoint at = at_m(volume.x_m, volume.y_m);
      svg.circle(view_.at(at), volume.radius_m * view_.pixels_per_m,
                 {.fill = "#f6d5d2", .stroke = alarm, .width = 1.2, .opacity = 0.8, .dash = "4 3"},
                 fmt::format("keep-out volume at ({:.1f}, {:.1f}) m, radius {:.1f} m", volume.x_m,
                             volume.y_m, volume.radius_m));
    }
  }

  void draw_contours(Svg& svg, const planner::Relief& relief) const {
    Extent extent{record_.scenario.field.boundary.front(), record_.scenario.field.boundary.front()};
    for (const FieldPoint p : record_.scenario.field.boundary) cover(extent, p);
    for (const Station& s : record_.scenario.stations) cover(extent, s.position);
    const Contours lines = contours(relief.surface(), extent);
    Chains chains;
    chains.reserve(lines.pieces.size());
    for (const auto& piece : lines.pieces) chains.push_back(pixels(view_, piece));
    svg.path(chains, false, {.stroke = "#8c7a52", .width = 0.7, .opacity = 0.7});
    if (lines.step_m > 0) {
      svg.text(view_.at(extent.south_west), fmt::format("contours every {:g} m", lines.step_m),
               {.size = 10, .fill = "#8c7a52", .halo = true});
    }
  }

  void draw_returns(Svg& svg, std::size_t uav) const {
    const scheduler::UavPlan& plan = uavs()[uav];
    std::size_t sortie = 0;
    for (const std::uint32_t cell : plan.solution.plan.returns) {
      const FieldPoint p = stop_after(plan.cells.first + cell);
      svg.circle(view_.at(p), 3.4, {.fill = "#fff", .stroke = ink, .width = 1.4},
                 fmt::format("UAV {}, return {} at ({:.1f}, {:.1f}) m", number(plan.vehicle.id),
                             ++sortie, p.x.base(), p.y.base()));
    }
  }

  void draw_labels(Svg& svg) const {
    const auto places = label_places(route_, uavs());
    for (std::size_t i = 0; i < uavs().size(); ++i) {
      for (const FieldPoint p : places[i]) {
        const Pixel at = view_.at(p);
        svg.text({at.x, at.y + 4}, fmt::format("{}", number(uavs()[i].vehicle.id)),
                 {.size = 13, .anchor = "middle", .fill = ink, .bold = true, .halo = true});
      }
    }
  }

  Chains track(const std::vector<TrackPoint>& points, bool spraying) const {
    constexpr double tolerance = 0.25;  // pixels
    Chains chains;
    std::vector<Pixel> chain;
    const auto finish = [&] {
      if (chain.size() > 1) chains.push_back(simplified(chain, tolerance));
      chain.clear();
    };
    for (std::size_t i = 1; i < points.size(); ++i) {
      if (points[i - 1].spraying != spraying) {
        finish();
        continue;
      }
      if (chain.empty()) chain.push_back(view_.at(points[i - 1].position));
      chain.push_back(view_.at(points[i].position));
    }
    finish();
    return chains;
  }

  void draw_landings(Svg& svg, std::size_t uav) const {
    for (const SortieFigures& s : result_.uavs[uav].sorties) {
      if (s.bay == 0) continue;
      svg.circle(
          view_.at(s.returned), 3.2, {.fill = colours_[uav], .stroke = ink, .width = 1.2},
          fmt::format("UAV {} returned at {:.1f} min", result_.uavs[uav].id, s.spray_ended_s / 60));
    }
  }

  void draw_loss(Svg& svg, std::size_t uav) const {
    if (!result_.uavs[uav].lost || flown_.uavs[uav].track.empty()) return;
    const Pixel p = view_.at(flown_.uavs[uav].track.back().position);
    const Chains cross{{{p.x - 6, p.y - 6}, {p.x + 6, p.y + 6}},
                       {{p.x - 6, p.y + 6}, {p.x + 6, p.y - 6}}};
    svg.path(cross, false, {.stroke = "#fff", .width = 5});
    svg.path(cross, false, {.stroke = alarm, .width = 2.5});
    svg.text({p.x + 9, p.y + 4}, fmt::format("UAV {} lost", result_.uavs[uav].id),
             {.size = 11, .fill = alarm, .bold = true, .halo = true});
  }

  // The route's cells that are chosen: squares, or bands along strips of any direction.
  template <class Chosen>
  void draw_chosen(Svg& svg, Chosen chosen, std::string_view colour) const {
    std::vector<FieldPoint> squares;
    Chains lines;
    for (const planner::Strip& strip : route_.strips) {
      const bool is_square = !planner::sprays_ends(strip);
      for (std::uint32_t i = strip.cells.first; i < end(strip.cells); ++i) {
        if (!chosen(i)) continue;
        if (is_square) {
          squares.push_back(route_.centers[i]);
        } else {
          lines.push_back({view_.at(planner::start_point(route_, strip, i)),
                           view_.at(planner::stop_point(route_, strip, i))});
        }
      }
    }
    draw_cells(svg, squares, colour);
    if (lines.empty()) return;
    const double width = std::max(route_.cell.base() * view_.pixels_per_m, 2.0);
    svg.path(lines, false, {.stroke = colour, .width = width});
  }

  // All squares of a colour are one path, as runs where neighbours follow each other.
  void draw_cells(Svg& svg, const std::vector<FieldPoint>& cells, std::string_view colour) const {
    const double side_m = route_.cell.base();
    const double half = std::max(side_m * view_.pixels_per_m, 2.0) / 2;
    Chains squares;
    for (std::size_t i = 0; i < cells.size();) {
      const bool upright = i + 1 < cells.size() && cells[i + 1].x == cells[i].x;
      std::size_t last = i;
      while (last + 1 < cells.size() &&
             distance(cells[last], cells[last + 1]).base() < 1.01 * side_m &&
             (upright ? cells[last + 1].x == cells[i].x : cells[last + 1].y == cells[i].y)) {
        ++last;
      }
      const Pixel a = view_.at(cells[i]), b = view_.at(cells[last]);
      const double west = std::min(a.x, b.x) - half, east = std::max(a.x, b.x) + half;
      const double north = std::min(a.y, b.y) - half, south = std::max(a.y, b.y) + half;
      squares.push_back({{west, north}, {east, north}, {east, south}, {west, south}});
      i = last + 1;
    }
    svg.path(squares, true, {.fill = colour});
  }

  // Each strip is cut into bins of a few pixels, coloured by the root mean square of their passes.
  void draw_offsets(Svg& svg) const {
    constexpr double bin_pixels = 7;
    const double swath_m = route_.cell.base();
    const auto bin = static_cast<std::uint32_t>(
        std::max(1.0, std::round(bin_pixels / (swath_m * view_.pixels_per_m))));
    std::vector<double> squares(route_.centers.size());
    std::vector<bool> passed(route_.centers.size());
    for (const Pass& pass : flown_.passes) {
      squares[pass.cell] = pass.offset_m * pass.offset_m;
      passed[pass.cell] = true;
    }
    std::array<Chains, offset_classes.size()> by_class;
    for (const planner::Strip& strip : route_.strips) {
      for (std::uint32_t first = strip.cells.first; first < end(strip.cells); first += bin) {
        const std::uint32_t last = std::min(first + bin, end(strip.cells));
        double sum = 0;
        std::uint32_t count = 0;
        for (std::uint32_t i = first; i < last; ++i) {
          if (!passed[i]) continue;
          sum += squares[i];
          ++count;
        }
        if (count == 0) continue;
        const double share = std::sqrt(sum / count) / swath_m;
        std::size_t k = 0;
        while (share >= offset_classes[k].below) ++k;
        const std::uint32_t onto = std::min(last, end(strip.cells) - 1);
        by_class[k].push_back({view_.at(route_.centers[first]), view_.at(route_.centers[onto])});
      }
    }
    for (std::size_t k = 0; k < by_class.size(); ++k) {
      svg.path(by_class[k], false,
               {.stroke = offset_classes[k].colour,
                .width = std::max(swath_m * view_.pixels_per_m * 0.92, 1.0)});
    }
  }

  const MissionRecord& record_;
  const planner::Route& route_;
  const Flown& flown_;
  const Result& result_;
  const Colours& colours_;
  View view_;
};

std::string key(std::string_view colour, std::string_view words, std::string_view shape = "") {
  return fmt::format("<li><i class=\"key {}\" style=\"background:{}\"></i>{}</li>", shape, colour,
                     escaped(words));
}

std::string survey_legend(const Result& result, const Colours& colours) {
  std::string items;
  for (std::size_t i = 0; i < result.uavs.size(); ++i) {
    items += key(colours[i], fmt::format("UAV {}: way points, ways", result.uavs[i].id));
  }
  items += key(ink, "supply station");
  return "<ul class=\"legend\">" + items + key("#f6d5d2", "keep-out volume") + "</ul>";
}

std::string legend(const Result& result, const Colours& colours, bool is_flown) {
  if (result.survey) return survey_legend(result, colours);
  std::string items;
  for (std::size_t i = 0; i < result.uavs.size(); ++i) {
    items += key(colours[i], fmt::format("UAV {}", result.uavs[i].id));
  }
  items += "<li><i class=\"key ring\"></i>return point</li>";
  items += key(ink, "supply station");
  items += key(alarm, "missed cell");
  if (!is_flown) return "<ul class=\"legend\">" + items + "</ul>";
  items += key("#6a3d9a", "cell sprayed twice");
  std::string classes;
  for (const OffsetClass& c : offset_classes) classes += key(c.colour, c.words);
  return "<ul class=\"legend\">" + items +
         "</ul><ul class=\"legend\"><li class=\"head\">True distance from the line</li>" + classes +
         "</ul>";
}

}  // namespace

std::string map_figure(const MissionRecord& record, const Flown& flown, const Result& result,
                       const Colours& colours) {
  const Panels panels{record, flown, result, colours};
  const bool is_flown = record.mode != Mode::plan;
  std::string figure = "<div class=\"maps\">" + panels.planned();
  if (is_flown) figure += panels.tracks();
  if (is_flown && !result.survey) figure += panels.accuracy();
  figure += footprint_panel(record, is_flown ? &flown : nullptr);
  return figure + "</div>" + legend(result, colours, is_flown) + footprint_legend(record);
}

}  // namespace furrow::app
