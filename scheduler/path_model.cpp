#include "scheduler/path_model.hpp"

#include "planner/fleet/bound.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace furrow::scheduler {
namespace {

namespace fleet = planner::fleet;

FieldPoint moved(FieldPoint from, FieldVector along, double share) {
  return from + FieldVector{share * along.x, share * along.y};
}

/// The strip from rim to rim of its cells.
fleet::StraightStrip from_rim_to_rim(const planner::Strip& strip, Length cell) {
  if (planner::sprays_ends(strip)) return {strip.begin, strip.end};
  const double half = 0.5 / std::max(1.0, static_cast<double>(strip.cells.count) - 1.0);
  const FieldVector along = strip.cells.count > 1 ? strip.to - strip.from : FieldVector{cell, {}};
  return {moved(strip.from, along, -half), moved(strip.to, along, half)};
}

fleet::Flier flier(const Vehicle& v) {
  return {.tank_m = tank_range(v).base(),
          .pack_s = usable_endurance(v).base(),
          .spray_mps = v.spray_speed.base(),
          .ferry_mps = v.ferry_speed.base(),
          .start = v.home};
}

fleet::Depot depot(const Station& s) {
  return {.position = s.position,
          .bays = s.bays,
          .service_s = s.fill_base.base(),
          .fill_s = (s.fill_full - s.fill_base).base()};
}

double mean_ferry_mps(std::span<const Vehicle> vehicles) {
  double sum_mps = 0.0;
  for (const Vehicle& v : vehicles) sum_mps += v.ferry_speed.base();
  return sum_mps / static_cast<double>(vehicles.size());
}

/// The route as bounds may take it: nobody sprays less or flies further.
std::optional<fleet::FleetProblem> bound_model(const planner::Route& route,
                                               std::span<const Vehicle> vehicles,
                                               std::span<const Station> stations) {
  std::vector<fleet::StraightStrip> strips;
  for (const planner::Strip& s : route.strips) {
    if (!(s.begin == s.end)) strips.push_back({s.begin, s.end});
  }
  if (strips.empty()) return std::nullopt;
  fleet::FleetProblem p{
      .path = fleet::StripPath{strips}, .fliers = {}, .depots = {}, .ends_sprayed = true};
  for (const Vehicle& v : vehicles) {
    p.fliers.push_back(flier(v));
    p.fliers.back().ferry_mps = std::max(p.fliers.back().ferry_mps, p.fliers.back().spray_mps);
  }
  for (const Station& s : stations) p.depots.push_back(depot(s));
  return p;
}

}  // namespace

std::optional<fleet::FleetProblem> search_model(const planner::Route& route,
                                                std::span<const Vehicle> vehicles,
                                                std::span<const Station> stations,
                                                const ModelMargins& margins) {
  constexpr double least_cells = 4.0;
  const double cell_m = route.cell.base();
  if (planner::is_survey(route)) return std::nullopt;
  const double loss_m = margins.hop_loss_s * mean_ferry_mps(vehicles);
  std::vector<fleet::StraightStrip> strips;
  strips.reserve(route.strips.size());
  for (const planner::Strip& s : route.strips) {
    fleet::StraightStrip strip = from_rim_to_rim(s, route.cell);
    if (!strips.empty() && !s.continues) {
      const planner::Strip& before = route.strips[strips.size() - 1];
      strip.hop_m = planner::approach_length(before, s).base() + loss_m;
    } else {
      strip.hop_m = loss_m;
    }
    strips.push_back(strip);
  }
  fleet::FleetProblem p{
      .path = fleet::StripPath{strips}, .fliers = {}, .depots = {}, .ends_sprayed = true};
  for (const Vehicle& v : vehicles) {
    fleet::Flier f = flier(v);
    f.tank_m -= margins.spare_cells * cell_m;
    f.pack_s *= margins.pack_share;
    f.sortie_s = margins.sortie_loss_s;
    if (f.tank_m <= least_cells * cell_m) return std::nullopt;
    p.fliers.push_back(f);
  }
  for (const Station& s : stations) p.depots.push_back(depot(s));
  return p;
}

std::uint32_t cells_before(const planner::Route& route, const fleet::StripPath& path, double at_m) {
  const std::uint32_t s = path.strip_to(at_m);
  const double share = (at_m - path.begin_m(s)) / (path.begin_m(s + 1) - path.begin_m(s));
  const CellRange cells = route.strips[s].cells;
  return cells.first + static_cast<std::uint32_t>(std::lround(share * cells.count));
}

double position_m(const planner::Route& route, const fleet::StripPath& path, std::uint32_t cells) {
  if (cells == 0) return 0.0;
  const auto s = static_cast<std::uint32_t>(planner::strip_of(route, cells - 1));
  const CellRange strip = route.strips[s].cells;
  const double share = static_cast<double>(cells - strip.first) / strip.count;
  return path.begin_m(s) + share * (path.begin_m(s + 1) - path.begin_m(s));
}

MakespanBound fleet_bound(const planner::Route& route, std::span<const Vehicle> vehicles,
                          std::span<const Station> stations) {
  constexpr fleet::BayBoundSettings quick{
      .slots = 60, .evaluations = 150, .fine_slots = 120, .fine_evaluations = 50};
  const auto model = bound_model(route, vehicles, stations);
  if (!model) return {0.0, {}};
  const fleet::LowerBound bound = fleet::best_bound(*model, quick);
  return {bound.makespan_s, std::string{bound.name}};
}

}  // namespace furrow::scheduler
