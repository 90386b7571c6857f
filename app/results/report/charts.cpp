#include "app/results/report/charts.hpp"

#include "app/results/report/palette.hpp"
#include "app/results/report/svg.hpp"
#include "app/results/report/view.hpp"

#include <algorithm>

namespace furrow::app {
namespace {

constexpr double width = 525, height = 210;
constexpr double left = 46, right = 10, top = 30, bottom = 36;

struct Bars {
  std::vector<double> heights;
  std::vector<std::string_view> colours;  ///< One, or one per bar.
};

// The frame of a chart whose x axis runs over [x_from, x_to] and y axis over [0, y_to].
struct Chart {
  double x_from, x_to, y_to;

  double x(double value) const {
    return left + (value - x_from) / (x_to - x_from) * (width - left - right);
  }
  double y(double value) const { return height - bottom - value / y_to * (height - top - bottom); }

  void draw(Svg& svg, const Bars& bars) const {
    const double step = round_step(y_to / 3);
    for (double v = 0; v <= y_to * 1.0001; v += step) {
      svg.line({left, y(v)}, {width - right, y(v)}, {.stroke = rule_line});
      svg.text({left - 5, y(v) + 3.5}, fmt::format("{:g}", std::round(v * 1e9) / 1e9),
               {.size = 10, .anchor = "end", .fill = faint_ink});
    }
    const double each = (width - left - right) / static_cast<double>(bars.heights.size());
    for (std::size_t i = 0; i < bars.heights.size(); ++i) {
      if (bars.heights[i] <= 0) continue;
      const double from = left + static_cast<double>(i) * each;
      const double gap = each > 4 ? 1 : 0;
      svg.rect({from + gap / 2, y(bars.heights[i])}, each - gap, y(0) - y(bars.heights[i]),
               {.fill = bars.colours[i % bars.colours.size()]});
    }
    svg.line({left, y(0)}, {width - right, y(0)}, {.stroke = faint_ink});
  }

  void label_x(Svg& svg, double value) const {
    svg.text({x(value), height - bottom + 14}, fmt::format("{:g}", std::round(value * 1e9) / 1e9),
             {.size = 10, .anchor = "middle", .fill = faint_ink});
  }
};

void label_axes(Svg& svg, std::string_view title, std::string_view x_axis) {
  svg.text({left, 15}, title, {.size = 12, .fill = ink, .bold = true});
  svg.text({left + (width - left - right) / 2, height - 5}, x_axis,
           {.size = 10, .anchor = "middle", .fill = faint_ink});
}

std::string histogram(const std::vector<Pass>& passes) {
  constexpr std::size_t bins = 41;  // odd: one of them is centred on the line
  std::vector<double> sizes;
  for (const Pass& pass : passes) sizes.push_back(std::abs(pass.offset_m));
  // The outermost 1 % go to the outermost bins, so that one excursion does not flatten the rest.
  const auto rank = static_cast<std::ptrdiff_t>(static_cast<double>(sizes.size() - 1) * 0.99);
  std::nth_element(sizes.begin(), sizes.begin() + rank, sizes.end());
  const double reach_m = std::max(sizes[static_cast<std::size_t>(rank)], 0.001);

  Bars bars{std::vector<double>(bins), {hues[0]}};
  for (const Pass& pass : passes) {
    const double place = (pass.offset_m / reach_m + 1) / 2 * bins;
    const double bin = std::clamp(std::floor(place), 0.0, static_cast<double>(bins - 1));
    bars.heights[static_cast<std::size_t>(bin)] += 100.0 / static_cast<double>(passes.size());
  }
  const double most = *std::max_element(bars.heights.begin(), bars.heights.end());
  const Chart chart{-reach_m * 100, reach_m * 100, most * 1.05};
  Svg svg{width, height, "How often each offset occurred"};
  label_axes(svg, "Share of cells, % ", "true offset, cm, right of the flown direction positive");
  chart.draw(svg, bars);
  const double step = round_step(reach_m * 100 / 2);
  for (double v = 0; v <= reach_m * 100; v += step) {
    chart.label_x(svg, v);
    if (v > 0) chart.label_x(svg, -v);
  }
  svg.line({chart.x(0), top}, {chart.x(0), height - bottom}, {.stroke = ink, .dash = "2 3"});
  return svg.markup();
}

std::string strip_bars(const MissionRecord& record, const Flown& flown, const Colours& colours) {
  constexpr std::size_t most_bars = 220;
  const auto& strips = record.plan.route.strips;
  std::vector<std::size_t> strip_of(record.plan.route.centers.size());
  for (std::size_t s = 0; s < strips.size(); ++s) {
    for (std::uint32_t i = strips[s].cells.first; i < end(strips[s].cells); ++i) strip_of[i] = s;
  }
  const std::size_t per_bar = (strips.size() + most_bars - 1) / most_bars;
  const std::size_t count = (strips.size() + per_bar - 1) / per_bar;
  std::vector<double> squares(count), passes(count);
  for (const Pass& pass : flown.passes) {
    squares[strip_of[pass.cell] / per_bar] += pass.offset_m * pass.offset_m;
    ++passes[strip_of[pass.cell] / per_bar];
  }
  Bars bars{std::vector<double>(count), std::vector<std::string_view>(count, faint_ink)};
  for (std::size_t i = 0; i < count; ++i) {
    if (passes[i] > 0) bars.heights[i] = 100 * std::sqrt(squares[i] / passes[i]);
  }
  for (std::size_t u = 0; u < record.plan.uavs.size(); ++u) {
    const CellRange share = record.plan.uavs[u].strips;
    for (std::uint32_t s = share.first; s < end(share); ++s) bars.colours[s / per_bar] = colours[u];
  }
  const double most = *std::max_element(bars.heights.begin(), bars.heights.end());
  const Chart chart{0.5, static_cast<double>(count * per_bar) + 0.5, std::max(most, 0.01) * 1.1};
  Svg svg{width, height, "Root mean square of each strip"};
  label_axes(svg, "RMS offset per strip, cm", "strip, in the UAV's colour");
  chart.draw(svg, bars);
  const double step = std::max(1.0, round_step(static_cast<double>(strips.size()) / 4));
  for (double v = step; v <= static_cast<double>(strips.size()); v += step) chart.label_x(svg, v);
  return svg.markup();
}

}  // namespace

std::string deviation_charts(const MissionRecord& record, const Flown& flown,
                             const Colours& colours) {
  if (flown.passes.empty() || record.plan.route.strips.empty()) return {};
  return "<div class=\"charts\">" + histogram(flown.passes) + strip_bars(record, flown, colours) +
         "</div>";
}

}  // namespace furrow::app
