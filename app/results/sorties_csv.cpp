#include "app/results/sorties_csv.hpp"

#include "app/results/rounding.hpp"

#include <fmt/format.h>

namespace furrow::app {
namespace {

std::string service(const SortieFigures& s) {
  if (s.bay == 0) return ",,,,,,,";
  return fmt::format("{},{},{},{},{},{},{},{}", s.station, s.bay, rounded(s.wait_s),
                     rounded(s.service_began_s), rounded(s.ready_s), rounded(s.battery_swap_s),
                     rounded(s.fill), rounded(s.fill_s));
}

}  // namespace

std::string sorties_csv(const Result& result) {
  std::string csv =
      "uav,sortie,start_x_m,start_y_m,return_x_m,return_y_m,spray_m,round_trip_m,flight_s,pack,"
      "battery_used,began_s,spray_began_s,spray_ended_s,landed_s,station,bay,wait_s,"
      "service_began_s,ready_s,battery_swap_s,fill,fill_s\r\n";
  for (const UavFigures& uav : result.uavs) {
    for (std::size_t k = 0; k < uav.sorties.size(); ++k) {
      const SortieFigures& s = uav.sorties[k];
      csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\r\n", uav.id, k + 1,
                         rounded(s.start.x.base()), rounded(s.start.y.base()),
                         rounded(s.returned.x.base()), rounded(s.returned.y.base()),
                         rounded(s.spray_m), rounded(s.round_trip_m), rounded(s.flight_s), s.pack,
                         rounded(s.battery_used), rounded(s.began_s), rounded(s.spray_began_s),
                         rounded(s.spray_ended_s), rounded(s.landed_s), service(s));
    }
  }
  return csv;
}

}  // namespace furrow::app
