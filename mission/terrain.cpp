#include "mission/terrain.hpp"

#include "exchange/heights.hpp"
#include "mission/search.hpp"

#include <fmt/format.h>

namespace furrow::mission {
namespace {

constexpr planner::RouteSettings ferry_search{.evaluations = 1000};
constexpr std::uint32_t most_evaluations = 100'000;  // for each of some hundred places
constexpr std::size_t most_peaks = 1'000, most_volumes = 1'000;

std::vector<planner::Peak> read_peaks(const Section& terrain) {
  std::vector<planner::Peak> peaks;
  for (const auto& s : terrain.list("peaks", 0, most_peaks)) {
    peaks.push_back({.top = s.point("top_m"),
                     .height = metres(s.number("height_m", above_to(0, 5000))),
                     .extent_x = metres(s.number("extent_east_m", above_to(1, 100'000))),
                     .extent_y = metres(s.number("extent_north_m", above_to(1, 100'000)))});
  }
  return peaks;
}

std::optional<planner::BaseTerrain> read_base(const Section& terrain) {
  const Section s = terrain.section("base");
  const auto constant = [&](const char* key) { return s.number(key, from_to(-1000, 1000), 0); };
  planner::BaseTerrain base{.a = constant("a"),
                            .b = constant("b"),
                            .c = constant("c"),
                            .d = constant("d"),
                            .e = constant("e"),
                            .f = constant("f"),
                            .g = constant("g")};
  base.wave = metres(s.number("wave_m", above_to(0, 100'000), 100));
  base.rise = metres(s.number("rise_m", above_to(0, 1000), 1));
  if (!terrain.has("base")) return std::nullopt;
  return base;
}

planner::HeightRule read_heights_kept(const Section& s) {
  planner::HeightRule rule;
  rule.spray_height = metres(s.number("spray_height_m", above_to(0, 100), 3));
  rule.clearance = metres(s.number("clearance_m", from_to(0, 1000), 15));
  if (const auto most = s.optional_number("ceiling_m", from_to(-1000, 10'000), "none")) {
    rule.ceiling = metres(*most);
  }
  rule.climb = metres_per_second(s.number("climb_mps", from_to(0.1, 50), 3));
  rule.descent = metres_per_second(s.number("descent_mps", from_to(0.1, 50), 2));
  rule.climb_energy_s_per_m = s.number("climb_energy_s_per_m", from_to(0, 10), 0.1);
  rule.slowest = s.number("slowest", from_to(0.05, 1), 0.25);
  rule.layers = static_cast<std::uint32_t>(s.whole("layers", 1, 100, 1));
  rule.layer = metres(s.number("layer_m", above_to(0, 100), 5));
  return rule;
}

std::vector<planner::KeepOut> read_keep_out(const Section& terrain) {
  std::vector<planner::KeepOut> volumes;
  for (const auto& s : terrain.list("keep_out", 0, most_volumes)) {
    const FieldPoint center = s.point("center_m");
    planner::KeepOut volume{.x_m = center.x.base(),
                            .y_m = center.y.base(),
                            .radius_m = s.number("radius_m", above_to(0, 10'000))};
    const auto bottom = s.optional_number("bottom_m", from_to(-1000, 10'000), "the ground");
    const auto top = s.optional_number("top_m", from_to(-1000, 10'000), "the sky");
    volume.bottom_m = bottom.value_or(volume.bottom_m);
    volume.top_m = top.value_or(volume.top_m);
    if (bottom && top && *bottom >= *top) {
      s.fail("bottom_m", fmt::format("must be less than top_m, {:.10g}", *top));
    }
    volumes.push_back(volume);
  }
  return volumes;
}

bool holds(const Raster& raster, FieldPoint p) {
  const FieldVector into = p - raster.south_west;
  const Length width = (raster.columns - 1.0) * raster.step;
  const Length depth = (raster.rows - 1.0) * raster.step;
  return into.x >= Length{} && into.y >= Length{} && into.x <= width && into.y <= depth;
}

std::optional<Raster> read_raster(const Section& terrain, const Scenario& scenario) {
  const auto file = terrain.optional_text("file", "peaks and base");
  if (!file) return std::nullopt;
  for (const char* key : {"peaks", "base"}) {
    if (terrain.has(key)) terrain.fail(key, "must be left out where file is given");
  }
  // A file without a CRS is in the field frame whatever the datum.
  const auto frame = exchange::LocalFrame{scenario.datum.value_or(exchange::Datum{})};
  auto raster = exchange::read_heights(terrain.findings().beside(*file), frame);
  if (!raster) {
    terrain.fail("file", raster.error().rule, fmt::format("{} in {}", raster.error().value, *file));
    return std::nullopt;
  }
  const auto lacks = [&](FieldPoint p, const char* rule) {
    if (holds(*raster, p)) return false;
    terrain.fail("file", rule, fmt::format("none at ({:.10g}, {:.10g}) m", p.x.base(), p.y.base()));
    return true;
  };
  for (const FieldPoint corner : scenario.field.boundary) {
    if (lacks(corner, "must hold heights for all of the field")) return std::nullopt;
  }
  for (const Station& station : scenario.stations) {
    if (lacks(station.position, "must hold heights for the stations")) return std::nullopt;
  }
  for (const Vehicle& uav : scenario.uavs) {
    if (lacks(uav.home, "must hold heights where aircraft start")) return std::nullopt;
  }
  return std::move(*raster);
}

}  // namespace

std::optional<planner::TerrainModel> read_terrain(const Section& s, const Scenario& scenario) {
  auto raster = read_raster(s, scenario);
  planner::AnalyticTerrain formula{.base = read_base(s), .peaks = read_peaks(s)};
  const bool is_level = !raster && !formula.base && formula.peaks.empty();
  planner::TerrainModel model{
      .ground = planner::AnalyticTerrain{},
      .rule = read_heights_kept(s),
      .keep_out = read_keep_out(s),
      .ferries = read_search(s.section("ferries"), ferry_search, most_evaluations, "shortest")};
  if (raster) {
    model.ground = std::move(*raster);
  } else {
    model.ground = std::move(formula);
  }
  if (!is_level) return model;
  const bool is_broken = s.has("file") || s.has("peaks") || s.has("base");
  for (const char* key :
       {"spray_height_m", "clearance_m", "ceiling_m", "climb_mps", "descent_mps",
        "climb_energy_s_per_m", "slowest", "layers", "layer_m", "keep_out", "ferries"}) {
    if (s.has(key) && !is_broken) {
      s.fail(key, "needs peaks, base or file: level land is flown without heights");
    }
  }
  return std::nullopt;
}

}  // namespace furrow::mission
