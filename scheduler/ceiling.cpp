#include "scheduler/ceiling.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace furrow::scheduler {
namespace {

class Ceiling {
 public:
  explicit Ceiling(const planner::FerryMap& ferries)
      : ferries_{ferries},
        relief_{*ferries.relief()},
        most_m_{relief_.rule().ceiling->base()},
        layer_{(relief_.rule().layers - 1.0) * relief_.rule().layer} {}

  std::optional<planner::PlanError> fault(FieldPoint from, FieldPoint to, const Vehicle& v) const {
    const auto way = ferries_.ferry_way(from, to, v);
    double highest_m = most_m_;
    for (const auto& leg : relief_.ferry(std::span{way}, v.ferry_speed, layer_).legs) {
      highest_m = std::max(highest_m, leg.altitude_m);
    }
    if (highest_m <= most_m_) return std::nullopt;
    return planner::PlanError{
        planner::PlanFault::ceiling_too_low,
        fmt::format("no ferry from ({:.3f}, {:.3f}) to ({:.3f}, {:.3f}) m was found below the "
                    "ceiling of {:.1f} m; the best flies at {:.1f} m",
                    from.x.base(), from.y.base(), to.x.base(), to.y.base(), most_m_, highest_m),
        from};
  }

 private:
  const planner::FerryMap& ferries_;
  const planner::Relief& relief_;
  double most_m_;
  Length layer_;
};

}  // namespace

std::optional<planner::PlanError> ceiling_fault(const FleetPlan& plan,
                                                std::span<const Station> stations) {
  const planner::Route& route = plan.route;
  const planner::Relief* relief = route.ferries.relief();
  if (relief == nullptr || !relief->rule().ceiling) return std::nullopt;
  if (relief->highest_ferry_m() <= relief->rule().ceiling->base()) return std::nullopt;
  const Ceiling ceiling{route.ferries};
  for (const UavPlan& uav : plan.uavs) {
    if (uav.cells.count == 0) continue;
    const auto stops = planner::cell_stops(route, uav.cells);
    const std::size_t first = planner::strip_of(route, uav.cells.first);
    const FieldPoint begin = planner::start_point(route, route.strips[first], uav.cells.first);
    if (auto fault = ceiling.fault(uav.vehicle.home, begin, uav.vehicle)) return fault;
    for (const planner::CellStop& at : stops) {
      for (const Station& station : stations) {
        if (auto fault = ceiling.fault(at.stop, station.position, uav.vehicle)) return fault;
        if (auto fault = ceiling.fault(station.position, at.resume, uav.vehicle)) return fault;
      }
    }
  }
  return std::nullopt;
}

}  // namespace furrow::scheduler
