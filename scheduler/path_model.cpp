#include "scheduler/path_model.hpp"

#include "core/corner.hpp"
#include "planner/fleet/bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
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
          .ready_s = v.available_from.base(),
          .start = v.home};
}

fleet::Depot depot(const Station& s) {
  return {.position = s.position,
          .bays = s.bays,
          .service_s = s.fill_base.base(),
          .fill_s = (s.fill_full - s.fill_base).base(),
          .swap_s = s.battery_swap.base()};
}

/// A flier as bounds may take it.
fleet::Flier fastest_flier(const Vehicle& v) {
  fleet::Flier f = flier(v);
  if (v.available_until) f.until_s = v.available_until->base();
  f.ferry_mps = std::max(f.ferry_mps, f.spray_mps);
  return f;
}

/// What the corners of a grid walk, cut with the valve open, spare the fleet at most. An arc that
/// leaves both legs c before a corner of angle q has the radius r = c / tan(q / 2) and is flown at
/// sqrt(a r), or at the spray speed if that is less.
class CutCorners {
 public:
  CutCorners(std::span<const Vehicle> vehicles, Length cell)
      : vehicles_{vehicles}, half_m_{0.5 * cell.base()} {}

  /// A hop as metres of ferry, longer by the slower flight with the valve open and shorter by both
  /// its corners.
  double hop_m(const planner::Strip& before, const planner::Strip& next) const {
    const FieldVector hop = next.begin - before.end;
    const double length_m = distance(before.end, next.begin).base();
    double ferried_m = std::numeric_limits<double>::infinity();
    for (const Vehicle& v : vehicles_) {
      const fleet::Flier f = fastest_flier(v);
      const double gain_s = gain_s_at(before, hop, v) + gain_s_at(next, hop, v);
      const double hop_mps = next.continues ? f.spray_mps : f.ferry_mps;
      ferried_m = std::min(ferried_m, (length_m / hop_mps - gain_s) * f.ferry_mps);
    }
    return ferried_m;
  }

  /// Of a way between a station and the path: at most the legs that the arc replaces.
  double way_m() const {
    double most_m = 0.0;
    for (const Vehicle& v : vehicles_) {
      const fleet::Flier f = fastest_flier(v);
      most_m = std::max(most_m, half_m_ * (1.0 + f.ferry_mps / f.spray_mps));
    }
    return most_m;
  }

 private:
  double gain_s_at(const planner::Strip& strip, FieldVector hop, const Vehicle& v) const {
    const double strip_m = distance(strip.begin, strip.end).base();
    const double hop_m = std::hypot(hop.x.base(), hop.y.base());
    const double cut_m = std::min({half_m_, 0.5 * strip_m, 0.5 * hop_m});
    const double angle = turn_rad(strip.end - strip.begin, hop);
    if (angle < straight_rad || cut_m <= 0.0) return 0.0;
    const double radius_m = cut_m / std::tan(0.5 * angle);
    const double turning_mps = std::sqrt(v.acceleration_limit.base() * radius_m);
    const double spray_mps = v.spray_speed.base();
    return std::max(0.0,
                    2.0 * cut_m / spray_mps - angle * radius_m / std::min(spray_mps, turning_mps));
  }

  std::span<const Vehicle> vehicles_;
  double half_m_;
};

/// The route as bounds may take it: nobody sprays less or flies further.
struct BoundModel {
  std::vector<fleet::StraightStrip> strips{};
  double way_cut_m = 0.0;
  double spared_m = 0.0;  ///< Of ferries, by corners of hops that are shorter than that.
};

BoundModel bound_strips(const planner::Route& route, std::span<const Vehicle> vehicles) {
  BoundModel model;
  const bool is_walk = !std::all_of(route.strips.begin(), route.strips.end(), planner::sprays_ends);
  const CutCorners corners{vehicles, route.cell};
  if (is_walk) model.way_cut_m = corners.way_m();
  const planner::Strip* before = nullptr;
  for (const planner::Strip& s : route.strips) {
    if (s.begin == s.end) continue;
    fleet::StraightStrip strip{s.begin, s.end};
    if (is_walk && before != nullptr) {
      const bool is_next = end(before->cells) == s.cells.first && s.approach.empty();
      const double hop_m = is_next ? corners.hop_m(*before, s) : 0.0;
      strip.hop_m = std::max(0.0, hop_m);
      model.spared_m += *strip.hop_m - hop_m;
    }
    model.strips.push_back(strip);
    before = &s;
  }
  return model;
}

fleet::FleetProblem bound_problem(const BoundModel& model, std::span<const Vehicle> vehicles,
                                  std::span<const Station> stations) {
  fleet::FleetProblem p{.path = fleet::StripPath{model.strips, model.way_cut_m},
                        .fliers = {},
                        .depots = {},
                        .ends_sprayed = true};
  for (const Vehicle& v : vehicles) p.fliers.push_back(fastest_flier(v));
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
  std::vector<fleet::StraightStrip> strips;
  strips.reserve(route.strips.size());
  for (const planner::Strip& s : route.strips) {
    fleet::StraightStrip strip = from_rim_to_rim(s, route.cell);
    if (!strips.empty() && !s.continues) {
      const planner::Strip& before = route.strips[strips.size() - 1];
      strip.hop_m = planner::approach_length(before, s).base();
    } else {
      strip.hop_m = 0.0;
    }
    strips.push_back(strip);
  }
  fleet::FleetProblem p{
      .path = fleet::StripPath{strips}, .fliers = {}, .depots = {}, .ends_sprayed = true};
  for (const Vehicle& v : vehicles) {
    fleet::Flier f = flier(v);
    f.tank_m -= margins.spare_cells * cell_m;
    f.pack_s = margins.pack_share * longest_flight_s(v);
    if (!margins.losses.empty()) {
      const FlightLoss& loss = margins.losses[p.fliers.size()];
      f.sortie_s = loss.flight_s;
      f.hop_s = loss.hop_s;
    }
    if (const auto until = planned_until(v)) f.until_s = until->base() - margins.early_s;
    if (f.tank_m <= least_cells * cell_m) return std::nullopt;
    p.fliers.push_back(f);
  }
  for (const Station& s : stations) {
    fleet::Depot d = depot(s);
    d.opens_s = s.available_from.base();
    if (const auto until = planned_until(s)) d.closes_s = until->base() - margins.early_s;
    p.depots.push_back(d);
  }
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
  const BoundModel model = bound_strips(route, vehicles);
  if (model.strips.empty()) return {0.0, {}};
  fleet::FleetProblem problem = bound_problem(model, vehicles, stations);
  double slowest_mps = std::numeric_limits<double>::infinity();
  double begins_s = std::numeric_limits<double>::infinity();
  for (const fleet::Flier& f : problem.fliers) {
    slowest_mps = std::min(slowest_mps, f.ferry_mps);
    begins_s = std::min(begins_s, f.ready_s);
  }
  for (fleet::Flier& f : problem.fliers) {
    f.ready_s -= begins_s;
    f.until_s -= begins_s;
  }
  const fleet::LowerBound bound = fleet::best_bound(problem, quick);
  return {begins_s + std::max(0.0, bound.makespan_s - model.spared_m / slowest_mps),
          std::string{bound.name}};
}

}  // namespace furrow::scheduler
