#include "app/results/report/view.hpp"

#include "app/results/report/palette.hpp"

#include <algorithm>

namespace furrow::app {
namespace {

void draw_north(Svg& svg, const View& view) {
  const double x = view.width - 16, y = 8;
  svg.path({{{x, y}, {x + 5, y + 14}, {x, y + 11}, {x - 5, y + 14}}}, true, {.fill = ink});
  svg.text({x, y + 25}, "N", {.size = 10, .anchor = "middle", .fill = ink, .bold = true});
}

void draw_scale(Svg& svg, const View& view) {
  const double length_m = round_step((view.width - 2 * View::margin) / view.pixels_per_m / 2.5);
  const double length = length_m * view.pixels_per_m;
  const double x = View::margin, y = view.height - 14;
  svg.path({{{x, y - 4}, {x, y}, {x + length, y}, {x + length, y - 4}}}, false,
           {.stroke = ink, .width = 1.2});
  svg.text({x + length + 6, y + 1}, fmt::format("{} m", length_m), {.size = 10, .fill = ink});
}

}  // namespace

std::vector<Pixel> pixels(const View& view, const std::vector<FieldPoint>& places) {
  std::vector<Pixel> chain;
  for (const FieldPoint p : places) chain.push_back(view.at(p));
  return chain;
}

double round_step(double limit) {
  if (!(limit > 0) || !std::isfinite(limit)) return 1;
  const double power = std::pow(10.0, std::floor(std::log10(limit)));
  for (const double k : {5.0, 2.0}) {
    if (k * power <= limit) return k * power;
  }
  return power;
}

View view_of(const mission::Scenario& scenario) {
  double west = INFINITY, east = -INFINITY, south = INFINITY, north = -INFINITY;
  const auto take = [&](FieldPoint p) {
    west = std::min(west, p.x.base());
    east = std::max(east, p.x.base());
    south = std::min(south, p.y.base());
    north = std::max(north, p.y.base());
  };
  for (const FieldPoint p : scenario.field.boundary) take(p);
  for (const Station& s : scenario.stations) take(s.position);
  const double wide_m = std::max(east - west, 1.0), tall_m = std::max(north - south, 1.0);
  const bool is_tall = tall_m > 1.6 * wide_m;  // panels then stand side by side
  const double most_wide = is_tall ? 400 : 1010, most_tall = is_tall ? 860 : 600;
  const double scale = std::min(most_wide / wide_m, most_tall / tall_m);
  return {.left_m = west,
          .top_m = north,
          .pixels_per_m = scale,
          .width = std::max(wide_m * scale, 120.0) + 2 * View::margin,
          .height = tall_m * scale + View::header + View::footer};
}

Svg land_panel(const View& view, const mission::Scenario& scenario, std::string_view heading) {
  Svg svg{view.width, view.height, heading};
  svg.text({View::margin, 14}, heading, {.size = 12.5, .fill = ink, .bold = true});
  std::vector<std::vector<Pixel>> rings{pixels(view, scenario.field.boundary)};
  for (const Ring& hole : scenario.field.holes) rings.push_back(pixels(view, hole));
  svg.path(rings, true, {.fill = "#f3f1e7", .stroke = "#7d7458", .width = 1.2});
  for (const Obstacle& o : scenario.field.obstacles) {
    const Paint paint{.fill = "#8d8d8d", .stroke = "#4d4d4d", .width = 0.8};
    if (!o.outline.empty()) {
      svg.path({pixels(view, o.outline)}, true, paint);
      continue;
    }
    svg.circle(view.at(o.center), std::max(o.radius.base() * view.pixels_per_m, 1.5), paint,
               "obstacle " + o.id);
  }
  draw_north(svg, view);
  draw_scale(svg, view);
  return svg;
}

void draw_stations(Svg& svg, const View& view, const mission::Scenario& scenario) {
  for (const Station& s : scenario.stations) {
    const Pixel p = view.at(s.position);
    svg.rect({p.x - 6, p.y - 6}, 12, 12, {.fill = ink, .stroke = "#fff", .width = 1.5}, 2,
             fmt::format("supply station {}, bays: {}", number(s.id), s.bays));
    svg.text({p.x, p.y + 3.2}, fmt::format("{}", number(s.id)),
             {.size = 9, .anchor = "middle", .fill = "#fff", .bold = true});
  }
}

}  // namespace furrow::app
