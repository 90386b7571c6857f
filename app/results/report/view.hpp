#pragma once

#include "app/results/mission_record.hpp"
#include "app/results/report/svg.hpp"

#include <string>

namespace furrow::app {

/// How the land is laid on a panel of the map.
struct View {
  double left_m, top_m;  ///< West edge and north edge of what is shown.
  double pixels_per_m;
  double width, height;  ///< Of the panel.

  static constexpr double margin = 30;
  static constexpr double header = 26;
  static constexpr double footer = 34;

  Pixel at(FieldPoint p) const {
    return {margin + (p.x.base() - left_m) * pixels_per_m,
            header + (top_m - p.y.base()) * pixels_per_m};
  }
};

/// Shows the field and the stations as large as a page allows.
View view_of(const mission::Scenario& scenario);

/// Places on the map, in order.
std::vector<Pixel> pixels(const View& view, const std::vector<FieldPoint>& places);

/// A panel with its heading, the land, a north arrow and a scale bar.
Svg land_panel(const View& view, const mission::Scenario& scenario, std::string_view heading);

/// The stations, to be drawn last.
void draw_stations(Svg& svg, const View& view, const mission::Scenario& scenario);

/// 1, 2 or 5 times a power of ten, at most `limit`, > 0.
double round_step(double limit);

}  // namespace furrow::app
