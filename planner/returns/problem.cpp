#include "planner/returns/problem.hpp"

#include "core/require.hpp"
#include "planner/ferry/turns.hpp"
#include "planner/returns/stops.hpp"

#include <utility>

namespace furrow::planner {
namespace {

// The route of a share at work height, followed from cell to cell.
class HillRoute {
 public:
  HillRoute(const Route& route, const ReturnProblem& problem, FieldPoint begin)
      : relief_{*route.ferries.relief()}, vehicle_{problem.vehicle}, at_{begin} {}

  void fly(FieldPoint to, Speed speed) {
    if (!(to == at_)) add(to, relief_.contour(at_, to, speed));
  }
  void approach(const Strip& strip) {
    if (!strip.approach_altitudes_m.empty()) return add(strip.begin, air_approach(strip));
    std::vector<FieldPoint> way{at_};
    way.insert(way.end(), strip.approach.begin(), strip.approach.end());
    way.push_back(strip.begin);
    if (is_high(way)) return add(strip.begin, relief_.ferry(way, vehicle_));
    for (const FieldPoint to : way) fly(to, vehicle_.ferry_speed);
  }
  void detour(double length_m) { time_s_ += length_m / vehicle_.spray_speed.base(); }
  double time_s() const { return time_s_; }
  double climb_s() const { return climb_s_; }

 private:
  void add(FieldPoint to, const AirWay& way) {
    const FlightCost cost = relief_.cost(at_, way);
    time_s_ += cost.time_s;
    climb_s_ += cost.energy_s - cost.time_s;
    at_ = to;
  }
  AirWay air_approach(const Strip& strip) const {
    const auto way = relief_.way_at(at_, strip.approach, strip.approach_altitudes_m, strip.begin);
    return relief_.straight(way, vehicle_.ferry_speed);
  }

  const Relief& relief_;
  const Vehicle& vehicle_;
  FieldPoint at_;
  double time_s_ = 0, climb_s_ = 0;
};

void follow_route(ReturnProblem& problem, const Route& route, const std::vector<CellStop>& stops,
                  FieldPoint begin) {
  HillRoute way{route, problem, begin};
  HillFlights& hills = *problem.hills;
  std::size_t s = strip_of(route, problem.cells.first);
  for (std::size_t k = 0; k < stops.size(); ++k) {
    const auto cell = static_cast<std::uint32_t>(problem.cells.first + k);
    if (k > 0 && cell == end(route.strips[s].cells)) {
      const Strip& strip = route.strips[++s];
      if (!strip.continues) way.approach(strip);
      if (!(stops[k - 1].resume == stops[k - 1].stop)) {
        hills.resume_climb_s[k - 1] = way.climb_s();
        problem.resume_s[k - 1] = way.time_s();
      }
    }
    way.fly(stops[k].stop, problem.vehicle.spray_speed);
    if (!route.detours.empty()) way.detour(route.detours[cell].longer_m);
    hills.late_s.push_back(way.time_s() - problem.on_route_s[k]);
    hills.climb_s.push_back(way.climb_s());
    problem.on_route_s[k] = problem.resume_s[k] = way.time_s();
    hills.resume_late_s.push_back(0.0);
    hills.resume_climb_s.push_back(hills.climb_s.back());
  }
}

// Of a ferry over hills, with what turning takes of the pack.
FlightCost ferry_cost(const Relief& relief, std::span<const FieldPoint> way, const Vehicle& v) {
  FlightCost cost = relief.cost(way.front(), relief.ferry(way, v));
  for (std::size_t i = 1; i + 1 < way.size(); ++i) {
    cost.energy_s += turn_loss_s(way[i - 1], way[i], way[i + 1], Corner::cut, v);
  }
  return cost;
}

// Takes the heights of the ground into a problem on level land.
void add_hills(ReturnProblem& problem, const Route& route, const std::vector<CellStop>& stops,
               FieldPoint begin) {
  const Vehicle& v = problem.vehicle;
  const std::vector<double> level_resume_s = problem.resume_s;
  problem.hills.emplace();
  follow_route(problem, route, stops, begin);
  HillFlights& hills = *problem.hills;
  const auto fly = [&](FieldPoint from, FieldPoint to, double& level_m) {
    const std::vector<FieldPoint> way = route.ferries.ferry_way(from, to, v);
    if (route.ferries.leads_past_hills()) level_m = way_length(way).base();
    return ferry_cost(*route.ferries.relief(), way, v);
  };
  const FieldPoint station = problem.station.position;
  for (std::size_t k = 0; k < stops.size(); ++k) {
    hills.back.push_back(fly(stops[k].stop, station, problem.back_m[k]));
    hills.out.push_back(fly(station, stops[k].resume, problem.out_m[k]));
  }
  hills.out[0] = fly(v.home, begin, problem.fly_out_m);
  for (std::size_t k = 0; k < stops.size(); ++k) {
    hills.resume_late_s[k] = problem.resume_s[k] - level_resume_s[k];
  }
  problem.resume_s[0] = hills.resume_late_s[0] = hills.resume_climb_s[0] = 0.0;
}

// Of level land: none is longer than it is.
HillFlights level_flights(const ReturnProblem& problem) {
  HillFlights level{};
  const std::size_t n = problem.spray_m.size();
  for (std::uint32_t i = 0; i < n; ++i) {
    level.back.push_back({problem.back_s(i), problem.back_s(i)});
    level.out.push_back({problem.out_s(i), problem.out_s(i)});
  }
  for (auto* sums : {&level.late_s, &level.resume_late_s, &level.climb_s, &level.resume_climb_s}) {
    sums->assign(n, 0.0);
  }
  return level;
}

// What turning at and between visits, and flying from rest to rest, takes of packs.
void add_turns(ReturnProblem& problem, const Route& route, const std::vector<CellStop>& stops) {
  if (!problem.hills) problem.hills = level_flights(problem);
  HillFlights& hills = *problem.hills;
  const Vehicle& v = problem.vehicle;
  const FieldPoint station = problem.station.position;
  const double rest_s = rest_loss_s(v);
  problem.kept_s = 6 * rest_s + 2;  // as aircraft judge whether they reach home
  FieldPoint before = v.home;
  double lost_s = 0;
  for (std::size_t k = 0; k < stops.size(); ++k) {
    if (k > 0) {
      FieldPoint at = stops[k - 1].stop;
      Corner corner = Corner::cut;
      const auto fly = [&](FieldPoint to) {
        lost_s += turn_loss_s(before, at, to, corner, v);
        before = at;
        at = to;
        corner = Corner::held;
      };
      for (const FieldPoint to : route.strips[problem.cells.first + k].approach) fly(to);
      fly(stops[k].stop);
      hills.resume_climb_s[k - 1] += lost_s;
    }
    hills.climb_s[k] += lost_s;
    hills.back[k].energy_s += rest_s + turn_loss_s(before, stops[k].stop, station, Corner::cut, v);
    hills.out[k].energy_s += rest_s;
  }
  hills.resume_climb_s.back() = hills.climb_s.back();
  hills.resume_climb_s[0] = 0.0;
}

// The same over hills, where banks are crossed between short strips and energy is planned closely.
void add_stops(ReturnProblem& problem, const Route& route, const std::vector<CellStop>& stops) {
  HillFlights& hills = *problem.hills;
  const Vehicle& v = problem.vehicle;
  std::size_t s = strip_of(route, problem.cells.first);
  double lost_s = 0;
  for (std::size_t k = 0; k < stops.size(); ++k) {
    if (problem.cells.first + k == end(route.strips[s].cells)) {
      const double joint_s = joint_loss_s(route.strips[s], route.strips[s + 1], v);
      lost_s += joint_s;
      ++s;
      const bool resumes_behind = !(stops[k - 1].resume == stops[k - 1].stop);
      if (resumes_behind) hills.resume_climb_s[k - 1] += joint_s;
    }
    hills.climb_s[k] += lost_s;
    hills.resume_climb_s[k] += lost_s;
    hills.back[k].energy_s += ferry_loss_s(route.strips[s], v);
    hills.out[k].energy_s += ferry_loss_s(route.strips[s], v);
  }
  hills.resume_climb_s[0] = 0.0;
}

}  // namespace

StationLengths station_lengths(const Route& route, FieldPoint station) {
  StationLengths lengths;
  const auto cells = static_cast<std::uint32_t>(route.centers.size());
  const std::vector<CellStop> at = cell_stops(route, {0, cells});
  for (const Strip& strip : route.strips) {
    std::vector<FieldPoint> line;
    for (std::uint32_t c = strip.cells.first; c < end(strip.cells); ++c) line.push_back(at[c].stop);
    const std::vector<double> ways_m = route.ferries.lengths_m(station, line);
    lengths.back_m.insert(lengths.back_m.end(), ways_m.begin(), ways_m.end());
  }
  lengths.out_m = lengths.back_m;
  for (std::uint32_t c = 0; c < cells; ++c) {
    if (at[c].resume == at[c].stop) continue;
    lengths.out_m[c] = route.ferries.length(at[c].resume, station).base();
  }
  return lengths;
}

StationLengths part(const StationLengths& whole, CellRange cells) {
  const auto first = static_cast<std::ptrdiff_t>(cells.first);
  const auto stop = static_cast<std::ptrdiff_t>(end(cells));
  return {.back_m = {whole.back_m.begin() + first, whole.back_m.begin() + stop},
          .out_m = {whole.out_m.begin() + first, whole.out_m.begin() + stop}};
}

ReturnProblem return_problem(const Route& route, CellRange cells, const Vehicle& vehicle,
                             const Station& station) {
  return return_problem(route, cells, vehicle, station,
                        part(station_lengths(route, station.position), cells));
}

ReturnProblem return_problem(const Route& route, CellRange cells, const Vehicle& vehicle,
                             const Station& station, StationLengths lengths) {
  require(lengths.back_m.size() == cells.count, "the lengths are those of the cells");
  const std::vector<CellStop> stops = cell_stops(route, cells);
  std::size_t strip = strip_of(route, cells.first);
  const FieldPoint begin = start_point(route, route.strips[strip], cells.first);
  ReturnProblem problem{.vehicle = vehicle,
                        .station = station,
                        .cells = cells,
                        .spray_m = {},
                        .on_route_s = {},
                        .back_m = {},
                        .resume_m = {},
                        .resume_s = {},
                        .out_m = {},
                        .fly_out_m = route.ferries.length(vehicle.home, begin).base(),
                        .strip_starts = {0}};
  while (++strip < route.strips.size() && route.strips[strip].cells.first < end(cells)) {
    problem.strip_starts.push_back(route.strips[strip].cells.first - cells.first);
  }
  // Metres and seconds from here on.
  const double spray_mps = vehicle.spray_speed.base(), ferry_mps = vehicle.ferry_speed.base();
  double ferried_s = 0.0;
  for (const CellStop& at : stops) {
    ferried_s += at.approach_m / ferry_mps;
    problem.spray_m.push_back(at.spray_m);
    problem.on_route_s.push_back((at.spray_m + at.dry_m) / spray_mps + ferried_s);
    problem.resume_m.push_back(at.spray_m);
    problem.resume_s.push_back(problem.on_route_s.back() + at.skipped_m / ferry_mps);
  }
  problem.back_m = std::move(lengths.back_m);
  problem.out_m = std::move(lengths.out_m);
  if (route.ferries.relief() != nullptr) add_hills(problem, route, stops, begin);
  // Where the share ends, nothing follows that a return could lead to.
  problem.out_m.back() = problem.back_m.back();
  problem.resume_m[0] = problem.resume_s[0] = 0.0;
  problem.out_m[0] = problem.fly_out_m;
  if (is_survey(route)) {
    add_turns(problem, route, stops);
  } else if (problem.hills) {
    add_stops(problem, route, stops);
  }
  return problem;
}

}  // namespace furrow::planner
