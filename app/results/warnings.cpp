#include "app/results/warnings.hpp"

#include "mission/place.hpp"
#include "scheduler/steep_ways.hpp"

#include <fmt/format.h>

namespace furrow::app {
namespace {

void add_uncovered(const Result& result, std::vector<std::string>& all) {
  if (!result.sweep) return;
  const planner::SprayedAreas& areas = result.sweep->areas;
  const double share = areas.missed / (areas.covered + areas.missed);
  if (!(share > 1e-3)) return;
  all.push_back(fmt::format("the planned rows leave {:.0f} m2 of the field unsprayed, {:.2f} %",
                            areas.missed.base(), 100 * share));
}

void add_strayed(const Result& result, std::vector<std::string>& all) {
  if (!(result.fleet.outside_at_work_m > 0.5)) return;
  all.push_back(
      fmt::format("ways between rows lead {:.0f} m over ground outside the field or in holes",
                  result.fleet.outside_at_work_m));
}

void add_unturned(const MissionRecord& record, std::vector<std::string>& all) {
  const auto& avoidance = record.plan.sweep ? record.plan.sweep->avoidance : std::nullopt;
  if (!avoidance || avoidance->unturned == 0) return;
  all.push_back(
      fmt::format("{} of {} turns between rows have no room for curves of the least turn "
                  "radius; they are made on the spot",
                  avoidance->unturned, avoidance->unturned + avoidance->turns));
}

void add_steep(const MissionRecord& record, std::vector<std::string>& all) {
  const auto add = [&](const scheduler::Steep& steep, const char* ways, const char* height) {
    if (!(steep.length_m > 0.5)) return;
    all.push_back(fmt::format(
        "{:.0f} m of {} are steeper than aircraft climb or descend at their least speed; {} is "
        "not kept there, first at {}",
        steep.length_m, ways, height, mission::place(*steep.first, record.scenario.datum)));
  };
  const scheduler::SteepWays steep = scheduler::steep_ways(record.plan);
  add(steep.rows, "rows", "the spray height");
  add(steep.between, "ways between rows, way points and stations", "their height");
}

}  // namespace

std::vector<std::string> warnings(const Result& result, const MissionRecord& record) {
  std::vector<std::string> all;
  add_uncovered(result, all);
  add_strayed(result, all);
  add_unturned(record, all);
  add_steep(record, all);
  for (const Envelope& envelope : record.log) {
    const auto* const event = std::get_if<Event>(&envelope.body);
    if (event == nullptr || event->kind != "land_left") continue;
    all.push_back(fmt::format("at {:.1f} s: {}", seconds(envelope.sent).base(), event->detail));
  }
  return all;
}

}  // namespace furrow::app
