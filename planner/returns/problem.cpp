#include "planner/returns/problem.hpp"

namespace furrow::planner {

ReturnProblem return_problem(const Route& route, CellRange cells, const Vehicle& vehicle,
                             const Station& station) {
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
                        .fly_out_m = distance(vehicle.home, begin).base(),
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
    problem.back_m.push_back(distance(at.stop, station.position).base());
    problem.resume_m.push_back(at.spray_m);
    problem.resume_s.push_back(problem.on_route_s.back() + at.skipped_m / ferry_mps);
    problem.out_m.push_back(distance(at.resume, station.position).base());
  }
  problem.resume_m[0] = problem.resume_s[0] = 0.0;
  problem.out_m[0] = problem.fly_out_m;
  return problem;
}

}  // namespace furrow::planner
