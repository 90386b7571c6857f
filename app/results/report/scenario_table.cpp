#include "app/results/report/html_table.hpp"
#include "app/results/report/tables.hpp"

#include "mission/polygon.hpp"

namespace furrow::app {
namespace {

bool same_kind(const Vehicle& a, const Vehicle& b) {
  return a.swath == b.swath && a.spray_speed == b.spray_speed && a.ferry_speed == b.ferry_speed &&
         a.spray_endurance == b.spray_endurance && a.flight_endurance == b.flight_endurance &&
         a.tank == b.tank && a.gnss.sigma == b.gnss.sigma && a.gnss.bias == b.gnss.bias &&
         a.available_from == b.available_from && a.available_until == b.available_until;
}

// Empty for one that is there all the time.
template <class T>
std::string window(const T& of) {
  std::string words;
  if (of.available_from > Seconds{}) {
    words += fmt::format(", from {:g} min", of.available_from.base() / 60);
  }
  if (of.available_until) words += fmt::format(", until {:g} min", of.available_until->base() / 60);
  return words;
}

std::string described(const Vehicle& v) {
  return fmt::format(
      "swath {:g} m, {:g} m/s spraying, {:g} m/s ferrying, {:g} min a tank of {:g} L ({:.1f} "
      "L/ha), "
      "{:g} min a pack, GNSS {:g} m noise and {:g} m bias{}",
      v.swath.base(), v.spray_speed.base(), v.ferry_speed.base(), v.spray_endurance.base() / 60,
      v.tank.base(), application_rate(v) / litres_per_hectare(1), v.flight_endurance.base() / 60,
      v.gnss.sigma.base(), v.gnss.bias.base(), window(v));
}

void add_vehicles(HtmlTable& table, const std::vector<Vehicle>& uavs) {
  for (std::size_t first = 0; first < uavs.size();) {
    std::size_t last = first;
    while (last + 1 < uavs.size() && same_kind(uavs[first], uavs[last + 1])) ++last;
    table.row({first == last
                   ? fmt::format("UAV {}", number(uavs[first].id))
                   : fmt::format("UAVs {} to {}", number(uavs[first].id), number(uavs[last].id)),
               described(uavs[first])});
    first = last + 1;
  }
}

std::string described(const mission::Fault& fault) {
  using Kind = mission::Fault::Kind;
  const std::uint32_t number = fault.target.number;
  if (fault.kind == Kind::agent_kill) return fmt::format("UAV {} dies", number);
  if (fault.kind == Kind::agent_join) return fmt::format("UAV {} joins", number);
  if (fault.kind == Kind::take_out) return fmt::format("UAV {} is taken out", number);
  if (fault.kind == Kind::pause) return "the operator pauses the fleet";
  if (fault.kind == Kind::resume) return "the operator lets the fleet go on";
  if (fault.kind == Kind::return_all) return "the operator calls the fleet to the stations";
  if (fault.kind == Kind::stop) return "the operator ends the mission";
  if (fault.bay == 0) return fmt::format("station {} shuts all its bays", number);
  return fmt::format("station {} shuts bay {}", number, fault.bay);
}

void add_land(HtmlTable& table, const mission::Scenario& s, double work_direction_deg) {
  table.row({"Field", fmt::format("{:.2f} ha, holes: {}, obstacles: {}, strips heading {:g}°",
                                  mission::area(s.field) / hectares(1), s.field.holes.size(),
                                  s.field.obstacles.size(), work_direction_deg)});
  if (s.datum) {
    table.row(
        {"Origin of the field frame", fmt::format("latitude {:.7f}°, longitude {:.7f}° (WGS84)",
                                                  s.datum->lat_deg, s.datum->lon_deg)});
  }
  if (s.stated_area) {
    const double off = mission::area(s.field) / *s.stated_area - 1;
    table.row({"Area stated by its file", fmt::format("{:.4f} ha; its land has {:+.2f} %",
                                                      *s.stated_area / hectares(1), 100 * off)});
  }
}

void add_stations(HtmlTable& table, const std::vector<Station>& stations) {
  for (const Station& station : stations) {
    table.row({fmt::format("Station {}", number(station.id)),
               fmt::format("at ({:.1f}, {:.1f}) m, bays: {}, battery swap {:g} s, filling {:g} to "
                           "{:g} s{}",
                           station.position.x.base(), station.position.y.base(), station.bays,
                           station.battery_swap.base(), station.fill_base.base(),
                           station.fill_full.base(), window(station))});
  }
}

void add_air(HtmlTable& table, const mission::Scenario& s) {
  table.row({"Wind", s.wind.mean.base() == 0 && s.wind.gust.base() == 0
                         ? "calm"
                         : fmt::format("{:g} m/s from {:g}°, gusts of {:g} m/s", s.wind.mean.base(),
                                       s.wind.from_deg, s.wind.gust.base())});
  table.row({"Radio",
             fmt::format("{:g} ms, jitter {:g} ms, loss {:g} %, doubled {:g} %",
                         seconds(s.link.latency).base() * 1e3, seconds(s.link.jitter).base() * 1e3,
                         100 * s.link.loss, 100 * s.link.duplication)});
}

}  // namespace

std::string scenario_table(const MissionRecord& record) {
  const mission::Scenario& s = record.scenario;
  HtmlTable table{"<What", "<How"};
  table.row({"Scenario", s.name});
  table.row({"Seed", fmt::format("{}", s.seed)});
  add_land(table, s, record.plan.work_direction_deg);
  if (s.survey) {
    table.row({"Survey", fmt::format("{} way points, {:g} m above the ground; ways by {}",
                                     s.survey->way_points.size(), s.survey->height.base(),
                                     planner::name(s.survey->search.planner))});
  }
  add_vehicles(table, s.uavs);
  add_stations(table, s.stations);
  add_air(table, s);
  for (const mission::Fault& fault : s.faults) {
    table.row({"Fault",
               fmt::format("{} at {:.1f} min", described(fault), seconds(fault.at).base() / 60)});
  }
  return table.markup();
}

}  // namespace furrow::app
