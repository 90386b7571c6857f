#include "planner/coverage/swath/finish.hpp"

#include "core/require.hpp"
#include "planner/at_once.hpp"
#include "planner/coverage/geos.hpp"
#include "planner/coverage/swath/joints.hpp"
#include "planner/coverage/swath/ragged_edges.hpp"
#include "planner/ferry/bends.hpp"

#include <algorithm>

namespace furrow::planner {
namespace {

constexpr std::size_t most_finished = 4;

double missed_m2(const StripOrder& order, const LandParts& land) {
  return area_m2(missed_land(runs_of(order.strips), land));
}

// Joins corners; strips are shortened for it only as far as no more than `may_miss_m2` is missed.
void join(StripOrder& order, const EdgeGrid& edges, const LandParts& land, double may_miss_m2) {
  StripOrder joined = order;
  const bool shortened = join_corners(joined, edges, Shortening::allowed);
  if (shortened && missed_m2(joined, land) > may_miss_m2) {
    joined = std::move(order);
    join_corners(joined, edges, Shortening::refused);
  }
  order = std::move(joined);
}

EdgeStrips missed_edges(const PartPlan& plan, const LandPart& flight, const LandParts& land,
                        const PlanRule& rule) {
  const SwathSettings& s = rule.settings;
  // A turn with the valve open, as edge strips take, would reach outside.
  if (s.edges == EdgeMode::stay_inside) return {{}, plan.missed_m2};
  return edge_strips(flight, land, runs_of(plan.order.strips), rule.swath_m, s.miss_tolerance,
                     s.min_strip.base());
}

void cover_edges(PartPlan& plan, const EdgeStrips& more, const LandPart& flight,
                 const LandParts& land, const InsidePaths& paths, const PlanRule& rule) {
  plan.groups.insert(plan.groups.end(), more.groups.begin(), more.groups.end());
  if (!more.groups.empty()) put_in_order(plan, flight, paths, rule);
  plan.missed_m2 = more.missed_m2;
  join(plan.order, paths.edges(), land,
       std::max(plan.missed_m2, rule.settings.miss_tolerance * area_m2(land)));
}

void finish(PartPlan& plan, const EdgeStrips& more, const LandPart& flight, const LandParts& land,
            const InsidePaths& paths, const PlanRule& rule) {
  if (rule.settings.edges == EdgeMode::cover_all) {
    cover_edges(plan, more, flight, land, paths, rule);
  }
  for (OrderedStrip& strip : plan.order.strips) {
    strip.approach = clear_of_corners(strip.approach, paths.edges(), rule.boom_m / 2);
  }
}

}  // namespace

std::vector<SprayedRun> runs_of(const std::vector<OrderedStrip>& strips) {
  std::vector<SprayedRun> runs;
  for (std::size_t i = 0; i < strips.size(); ++i) {
    const GroundStrip& s = strips[i].strip;
    const bool continues = i > 0 && norm(s.a - strips[i - 1].strip.b) <= 1e-9 &&
                           s.half_width_m == strips[i - 1].strip.half_width_m;
    if (continues) {
      runs.back().path.push_back(s.b);
    } else {
      runs.push_back({{s.a, s.b}, 2 * s.half_width_m});
    }
  }
  return runs;
}

PartPlan cheapest_finished(std::vector<PartPlan> plans, const LandPart& flight,
                           const LandParts& land, const InsidePaths& paths, const PlanRule& rule) {
  require(!plans.empty(), "a part has a plan");
  // Nothing that is finished in `stay_inside` costs more than before.
  const bool adds = rule.settings.edges == EdgeMode::cover_all;
  plans.resize(std::min(plans.size(), adds ? most_finished : 1));
  const auto more = at_once(
      plans.size(), [&](std::size_t i) { return missed_edges(plans[i], flight, land, rule); });
  std::size_t best = 0;
  for (std::size_t i = 0; i < plans.size(); ++i) {
    finish(plans[i], more[i], flight, land, paths, rule);
    if (cost_m(plans[i], rule) < cost_m(plans[best], rule)) best = i;
  }
  return std::move(plans[best]);
}

}  // namespace furrow::planner
