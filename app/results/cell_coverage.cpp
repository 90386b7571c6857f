#include "app/results/cell_coverage.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>

namespace furrow::app {
namespace {

// Each cell's length as a share of the nominal cell: 1 where cells are squares, 0 on a survey.
std::vector<double> cell_shares(const planner::Route& route) {
  if (planner::is_survey(route)) return std::vector<double>(route.centers.size());
  std::vector<double> shares = planner::cell_lengths_m(route);
  for (double& length : shares) length /= route.cell.base();
  for (const planner::Strip& strip : route.strips) {
    if (strip.width == Length{}) continue;
    const double part = strip.width / route.cell;
    for (std::uint32_t c = strip.cells.first; c < end(strip.cells); ++c) shares[c] *= part;
  }
  return shares;
}

double sum(std::span<const double> shares) {
  return std::accumulate(shares.begin(), shares.end(), 0.0);
}

double cell_area_m2(const planner::Route& route) { return route.cell.base() * route.cell.base(); }

}  // namespace

std::vector<double> share_areas_m2(const scheduler::FleetPlan& plan) {
  const std::vector<double> shares = cell_shares(plan.route);
  std::vector<double> areas;
  areas.reserve(plan.uavs.size());
  for (const scheduler::UavPlan& uav : plan.uavs) {
    const std::span<const double> its{shares.data() + uav.cells.first, uav.cells.count};
    areas.push_back(sum(its) * cell_area_m2(plan.route));
  }
  return areas;
}

std::vector<Pass> planned_passes(const scheduler::FleetPlan& plan) {
  std::vector<Pass> passes;
  passes.reserve(plan.route.centers.size());
  for (const scheduler::UavPlan& uav : plan.uavs) {
    for (std::uint32_t i = uav.cells.first; i < end(uav.cells); ++i) passes.push_back({i, 0.0});
  }
  return passes;
}

CoverageFigures planned_coverage(const MissionRecord& record) {
  const planner::Route& route = record.plan.route;
  std::vector<std::uint32_t> times(route.centers.size());
  for (const scheduler::UavPlan& uav : record.plan.uavs) {
    for (std::uint32_t i = uav.cells.first; i < end(uav.cells); ++i) ++times[i];
  }
  const std::vector<double> shares = cell_shares(route);
  double covered = 0, repeated = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    covered += times[i] > 0 ? shares[i] : 0;
    repeated += times[i] > 1 ? shares[i] * (times[i] - 1) : 0;
  }
  const double cells = sum(shares);
  const double unrouted = static_cast<double>(route.missed.size());
  const double cell_m2 = cell_area_m2(record.plan.route);
  return {.covered_m2 = covered * cell_m2,
          .missed_m2 = (cells - covered + unrouted) * cell_m2,
          .repeated_m2 = repeated * cell_m2,
          .outside_m2 = 0,
          .unrouted_m2 = unrouted * cell_m2,
          .abandoned_m2 = (cells - covered) * cell_m2,
          .uncertain_m2 = 0};
}

CoverageFigures flown_coverage(const MissionRecord& record, const Flown& flown,
                               const FootprintFigures& wetted) {
  std::vector<std::uint32_t> passes(flown.proofs.size());
  for (const Pass& pass : flown.passes) ++passes[pass.cell];
  const std::vector<double> shares = cell_shares(record.plan.route);
  double covered = 0, repeated = 0, uncertain = 0;
  for (std::size_t i = 0; i < passes.size(); ++i) {
    const std::uint32_t times = std::max(passes[i], flown.proofs[i]);
    covered += flown.proofs[i] > 0 ? shares[i] : 0;
    repeated += times > 1 ? shares[i] * (times - 1) : 0;
    uncertain += flown.proofs[i] == 0 && passes[i] > 0 ? shares[i] : 0;
  }
  const double cells = sum(shares);
  const double unrouted = static_cast<double>(record.plan.route.missed.size());
  // The scheduler gives their number only: cells of mean length.
  const double mean = passes.empty() ? 1.0 : cells / static_cast<double>(passes.size());
  const double abandoned = mean * (flown.last_word ? flown.last_word->abandoned_cells : 0);
  const double cell_m2 = cell_area_m2(record.plan.route);
  return {.covered_m2 = covered * cell_m2,
          .missed_m2 = (cells - covered + unrouted) * cell_m2,
          .repeated_m2 = repeated * cell_m2,
          .outside_m2 = wetted.outside_m2,
          .unrouted_m2 = unrouted * cell_m2,
          .abandoned_m2 = abandoned * cell_m2,
          .uncertain_m2 = uncertain * cell_m2};
}

SurveyFigures planned_survey(const MissionRecord& record) {
  SurveyFigures f{};
  f.way_points = static_cast<std::uint32_t>(record.plan.route.centers.size());
  for (const scheduler::UavPlan& uav : record.plan.uavs) f.visited += uav.cells.count;
  return f;
}

SurveyFigures flown_survey(const Flown& flown) {
  SurveyFigures f{};
  f.way_points = static_cast<std::uint32_t>(flown.proofs.size());
  std::vector<bool> is_passed(flown.proofs.size());
  for (const Pass& pass : flown.passes) is_passed[pass.cell] = true;
  for (std::size_t i = 0; i < is_passed.size(); ++i) {
    f.visited += flown.proofs[i] > 0;
    f.uncertain += flown.proofs[i] == 0 && is_passed[i];
  }
  return f;
}

}  // namespace furrow::app
