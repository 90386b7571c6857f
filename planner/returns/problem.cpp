#include "planner/returns/problem.hpp"

namespace furrow::planner {

StationLengths station_lengths(const Route& route, FieldPoint station) {
  StationLengths lengths;
  const auto cells = static_cast<std::uint32_t>(route.centers.size());
  for (const CellStop& at : cell_stops(route, {0, cells})) {
    lengths.back_m.push_back(route.ferries.length(at.stop, station).base());
    lengths.out_m.push_back(at.resume == at.stop ? lengths.back_m.back()
                                                 : route.ferries.length(at.resume, station).base());
  }
  return lengths;
}

ReturnProblem return_problem(const Route& route, CellRange cells, const Vehicle& vehicle,
                             const Station& station) {
  return return_problem(route, cells, vehicle, station, station_lengths(route, station.position));
}

ReturnProblem return_problem(const Route& route, CellRange cells, const Vehicle& vehicle,
                             const Station& station, const StationLengths& lengths) {
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
    problem.on_route_s.push_back(at.spray_m / spray_mps + ferried_s);
    problem.resume_m.push_back(at.spray_m);
    problem.resume_s.push_back(problem.on_route_s.back() + at.skipped_m / ferry_mps);
  }
  const auto first = static_cast<std::ptrdiff_t>(cells.first);
  const auto stop = static_cast<std::ptrdiff_t>(end(cells));
  problem.back_m.assign(lengths.back_m.begin() + first, lengths.back_m.begin() + stop);
  problem.out_m.assign(lengths.out_m.begin() + first, lengths.out_m.begin() + stop);
  // Where the share ends, nothing follows that a return could lead to.
  problem.out_m.back() = problem.back_m.back();
  problem.resume_m[0] = problem.resume_s[0] = 0.0;
  problem.out_m[0] = problem.fly_out_m;
  return problem;
}

}  // namespace furrow::planner
