#include "app/results/report/height_charts.hpp"

#include "app/results/report/palette.hpp"
#include "app/results/report/view.hpp"

#include <algorithm>
#include <array>

namespace furrow::app {
namespace {

constexpr double width = 1060, height = 230;
constexpr double left = 46, right = 10, top = 30, bottom = 36;
constexpr std::size_t most_charts = 6;
constexpr std::string_view soil = "#e6dcc6", soil_line = "#8c7a52";

// A place of a flight, along its way.
struct Stop {
  double along_m, ground_m, kept_m, flown_m;
};

std::vector<Stop> side_view(const planner::Relief& relief, const FlownUav& uav) {
  std::vector<Stop> stops;
  const SortieReport& sortie = uav.sorties.front();
  double along_m = 0;
  const TrackPoint* before = nullptr;
  for (const TrackPoint& p : uav.track) {
    if (p.at < sortie.began || p.at > sortie.landed) continue;
    if (before != nullptr) along_m += distance(before->position, p.position).base();
    before = &p;
    const double ground_m = relief.surface().height(p.position).base();
    stops.push_back({along_m, ground_m, ground_m + relief.rule().clearance.base(), p.altitude_m});
  }
  return stops;
}

// Pixels of a side view.
class Frame {
 public:
  explicit Frame(const std::vector<Stop>& stops)
      : length_m_{std::max(1.0, stops.back().along_m)},
        low_m_{stops.front().ground_m},
        high_m_{low_m_ + 1} {
    for (const Stop& s : stops) {
      low_m_ = std::min(low_m_, s.ground_m);
      high_m_ = std::max({high_m_, s.kept_m, s.flown_m});
    }
  }

  Pixel at(double along_m, double altitude_m) const {
    return {left + along_m / length_m_ * (width - left - right),
            height - bottom - (altitude_m - low_m_) / (high_m_ - low_m_) * (height - top - bottom)};
  }
  double length_m() const { return length_m_; }
  double low_m() const { return low_m_; }
  double high_m() const { return high_m_; }

  std::vector<Pixel> line(const std::vector<Stop>& stops, double Stop::*altitude_m) const {
    std::vector<Pixel> chain;
    chain.reserve(stops.size());
    for (const Stop& s : stops) chain.push_back(at(s.along_m, s.*altitude_m));
    return chain;
  }

 private:
  double length_m_, low_m_, high_m_;
};

void draw_axes(Svg& svg, const Frame& frame) {
  const double rise = round_step((frame.high_m() - frame.low_m()) / 4);
  for (double v = std::ceil(frame.low_m() / rise) * rise; v <= frame.high_m(); v += rise) {
    const Pixel from = frame.at(0, v);
    svg.line(from, frame.at(frame.length_m(), v), {.stroke = rule_line});
    svg.text({left - 5, from.y + 3.5}, fmt::format("{:g}", v),
             {.size = 10, .anchor = "end", .fill = faint_ink});
  }
  const double run = round_step(frame.length_m() / 6);
  for (double v = 0; v <= frame.length_m(); v += run) {
    svg.text({frame.at(v, 0).x, height - bottom + 14}, fmt::format("{:g}", v),
             {.size = 10, .anchor = "middle", .fill = faint_ink});
  }
  svg.text({left + (width - left - right) / 2, height - 5}, "way flown, m",
           {.size = 10, .anchor = "middle", .fill = faint_ink});
}

std::string chart(const planner::Relief& relief, const FlownUav& uav, std::uint32_t id,
                  std::string_view colour) {
  const std::vector<Stop> stops = side_view(relief, uav);
  if (stops.size() < 2) return {};
  double least_m = stops.front().flown_m - stops.front().ground_m;
  for (const Stop& s : stops) least_m = std::min(least_m, s.flown_m - s.ground_m);
  const Frame frame{stops};
  Svg svg{width, height, "Height flown over the ground"};
  std::vector<Pixel> ground = frame.line(stops, &Stop::ground_m);
  ground.push_back(frame.at(frame.length_m(), frame.low_m()));
  ground.push_back(frame.at(0, frame.low_m()));
  svg.path({ground}, true, {.fill = soil, .stroke = soil_line});
  draw_axes(svg, frame);
  svg.path({frame.line(stops, &Stop::kept_m)}, false,
           {.stroke = soil_line, .width = 0.8, .dash = "3 3"});
  svg.path({frame.line(stops, &Stop::flown_m)}, false, {.stroke = colour, .width = 1.6});
  svg.text({left, 15},
           fmt::format("UAV {}, sortie 1: height above the datum, m; least {:.1f} m above the "
                       "ground; dashed: the clearance of ways, {:g} m",
                       id, least_m, relief.rule().clearance.base()),
           {.size = 12, .fill = ink, .bold = true});
  return svg.markup();
}

// The contour of `level_m` through a square of four corners: none, one or two pieces.
void add_pieces(const std::array<FieldPoint, 4>& corners, const std::array<double, 4>& heights_m,
                double level_m, std::vector<std::vector<FieldPoint>>& pieces) {
  std::vector<FieldPoint> cuts;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t j = (i + 1) % 4;
    const double a = heights_m[i], b = heights_m[j];
    if ((a < level_m) == (b < level_m)) continue;
    const double t = (level_m - a) / (b - a);
    const FieldVector edge = corners[j] - corners[i];
    cuts.push_back(corners[i] + FieldVector{t * edge.x, t * edge.y});
  }
  for (std::size_t i = 0; i + 1 < cuts.size(); i += 2) pieces.push_back({cuts[i], cuts[i + 1]});
}

}  // namespace

Contours contours(const planner::Surface& surface, const Extent& extent) {
  constexpr std::size_t cells = 80;
  constexpr double lines = 10, level_within_m = 0.1;
  const FieldVector size = extent.north_east - extent.south_west;
  const auto place = [&](std::size_t i, std::size_t j) {
    return extent.south_west + FieldVector{(static_cast<double>(i) / cells) * size.x,
                                           (static_cast<double>(j) / cells) * size.y};
  };
  double low_m = surface.height(extent.south_west).base(), high_m = low_m;
  for (std::size_t i = 0; i <= cells; ++i) {
    for (std::size_t j = 0; j <= cells; ++j) {
      const double h = surface.height(place(i, j)).base();
      low_m = std::min(low_m, h);
      high_m = std::max(high_m, h);
    }
  }
  if (high_m - low_m < level_within_m) return {0, {}};
  Contours made{round_step((high_m - low_m) / lines), {}};
  for (std::size_t i = 0; i < cells; ++i) {
    for (std::size_t j = 0; j < cells; ++j) {
      const std::array corners{place(i, j), place(i + 1, j), place(i + 1, j + 1), place(i, j + 1)};
      std::array<double, 4> heights_m{};
      for (std::size_t k = 0; k < 4; ++k) heights_m[k] = surface.height(corners[k]).base();
      const auto [least, most] = std::minmax_element(heights_m.begin(), heights_m.end());
      const auto from = static_cast<int>(std::floor(*least / made.step_m)) + 1;
      const auto to = static_cast<int>(std::floor(*most / made.step_m));
      for (int n = from; n <= to; ++n) add_pieces(corners, heights_m, n * made.step_m, made.pieces);
    }
  }
  return made;
}

std::string height_charts(const MissionRecord& record, const Flown& flown, const Colours& colours) {
  const planner::Relief* relief = record.plan.route.ferries.relief();
  if (relief == nullptr) return {};
  std::string charts;
  std::size_t drawn = 0;
  for (std::size_t u = 0; u < flown.uavs.size() && drawn < most_charts; ++u) {
    if (flown.uavs[u].sorties.empty()) continue;
    charts += chart(*relief, flown.uavs[u], number(record.plan.uavs[u].vehicle.id), colours[u]);
    ++drawn;
  }
  return charts.empty() ? charts : "<div class=\"charts\">" + charts + "</div>";
}

}  // namespace furrow::app
