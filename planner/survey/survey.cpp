#include "planner/survey/survey.hpp"

#include "core/random.hpp"
#include "core/require.hpp"
#include "planner/routes/drawn.hpp"
#include "planner/routes/route_cost.hpp"
#include "planner/survey/tour.hpp"

#include <algorithm>
#include <cmath>

namespace furrow::planner {
namespace {

constexpr double spare_m = 0.5;    // kept over the clearance: ways are drawn by few points
constexpr double drawn_m = 0.25;   // how far these may be off the curve
constexpr double headroom_m = 60;  // over the highest ferry where there is no ceiling

FieldPoint place(WayPoint p) { return at_m(p.x_m, p.y_m); }

// From one way point to the next, its ends left out.
struct Leg {
  std::vector<FieldPoint> places;
  std::vector<double> altitudes_m;  // none: work height
};

class Legs {
 public:
  Legs(const SurveySettings& survey, const SurveyRule& rule, const FerryMap& ferries)
      : survey_{survey},
        rule_{rule},
        ferries_{ferries},
        box_{rule.field.boundary.front(), rule.field.boundary.front()} {
    for (const FieldPoint corner : rule.field.boundary) cover(box_, corner);
  }

  Leg leg(FieldPoint from, FieldPoint to, std::uint64_t number) const {
    if (const Relief* relief = ferries_.relief()) {
      const HeightRule& heights = relief->rule();
      const double vertical_mps = std::min(heights.climb, heights.descent).base();
      const double level = vertical_mps / rule_.speed.base();
      for (const double steepest : {level, level / heights.slowest}) {
        auto found = searched(*relief, from, to, steepest, number);
        if (!found.places.empty()) return found;
      }
    }
    std::vector<FieldPoint> way = ferries_.way(from, to);
    return {{way.begin() + 1, way.end() - 1}, {}};
  }

 private:
  Scene scene(const Relief& relief, FieldPoint from, FieldPoint to) const {
    const auto over = [&](FieldPoint p) {
      return WayPoint{p.x.base(), p.y.base(), relief.work_altitude_m(p)};
    };
    const std::vector<float>& ground = relief.surface().raster().heights_m;
    const double high_m = relief.rule().ceiling ? relief.rule().ceiling->base()
                                                : relief.highest_ferry_m() + headroom_m;
    const Length kept = std::min(relief.rule().clearance + metres(spare_m),
                                 relief.rule().spray_height - relief.surface().error());
    Scene made{.surface = relief.surface(),
               .low = {box_.south_west.x.base(), box_.south_west.y.base(),
                       *std::min_element(ground.begin(), ground.end())},
               .high = {box_.north_east.x.base(), box_.north_east.y.base(), high_m},
               .keep_out = relief.keep_out(),
               .clearance_m = std::max(0.0, kept.base()),
               .start = over(from),
               .goal = over(to),
               .least_turn_radius_m = rule_.turn_radius.base()};
    for (const Obstacle& o : rule_.field.obstacles) {
      made.keep_out.push_back(
          {.x_m = o.center.x.base(), .y_m = o.center.y.base(), .radius_m = o.radius.base()});
    }
    for (KeepOut& volume : made.keep_out) volume.radius_m += rule_.apart.base();
    return made;
  }

  // Empty where none is found that stays on the land.
  Leg searched(const Relief& relief, FieldPoint from, FieldPoint to, double steepest,
               std::uint64_t number) const {
    Scene air = scene(relief, from, to);
    air.steepest_climb = steepest;
    RouteSettings settings = survey_.search;
    settings.seed = seed_for(settings.seed, {number});
    const auto route = plan_route(air, settings);
    if (!route) return {};
    const std::vector<WayPoint> curve = flown(air, route->genes);
    std::vector<WayPoint> line = drawn(curve, drawn_m);
    if (line.empty()) line.push_back(curve[curve.size() / 2]);
    Leg leg;
    FieldPoint at = from;
    for (const WayPoint p : line) {
      if (leaves_land(at, place(p))) return {};
      at = place(p);
      leg.places.push_back(at);
      leg.altitudes_m.push_back(p.z_m);
    }
    return leaves_land(at, to) ? Leg{} : leg;
  }

  bool leaves_land(FieldPoint from, FieldPoint to) const {
    constexpr double rounding_m = 1e-6;
    if (!contains(rule_.field.boundary, to)) return true;
    return (ferries_.length(from, to) - distance(from, to)).base() > rounding_m;
  }

  const SurveySettings& survey_;
  const SurveyRule& rule_;
  const FerryMap& ferries_;
  Extent box_;
};

}  // namespace

std::vector<std::uint32_t> survey_tour(const SurveySettings& survey, const FerryMap& ferries,
                                       FieldPoint from) {
  const auto count = static_cast<std::uint32_t>(survey.way_points.size());
  const auto at = [&](std::uint32_t i) { return i == 0 ? from : survey.way_points[i - 1]; };
  auto order = tour(count + 1, [&](std::uint32_t i, std::uint32_t j) {
    return ferries.length(at(i), at(j)).base();
  });
  order.erase(order.begin());
  for (std::uint32_t& place : order) --place;
  return order;
}

Route survey_route(const SurveySettings& survey, const SurveyRule& rule, const FerryMap& ferries,
                   std::span<const std::uint32_t> order) {
  require(!survey.way_points.empty() && order.size() == survey.way_points.size(),
          "a survey has a way point, and every one its place");
  Route route{.cell = {}, .centers = {}, .strips = {}, .missed = {}, .ferries = ferries};
  const Legs legs{survey, rule, ferries};
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    const FieldPoint to = survey.way_points[order[i]];
    Strip visit = centre_strip({i, 1}, to, to, false);
    if (i > 0) {
      Leg leg = legs.leg(route.centers.back(), to, i);
      visit.approach = std::move(leg.places);
      visit.approach_altitudes_m = std::move(leg.altitudes_m);
    }
    route.centers.push_back(to);
    route.strips.push_back(std::move(visit));
  }
  return route;
}

}  // namespace furrow::planner
