#include "app/results/terminal.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace furrow::app {
namespace {

constexpr std::size_t most_columns = 100;
constexpr std::size_t most_uav_rows = 40;
constexpr double redraw_s = 0.1;

// Cut to the width of the table; cells are ASCII but for names, which may then lose a letter.
std::string cut(std::string line) {
  if (line.size() > most_columns) line = line.substr(0, most_columns - 3) + "...";
  return line + '\n';
}

std::string state(const Result& r) {
  if (r.partial) return "interrupted";
  if (r.mode == Mode::plan) return "planned";
  return r.completed ? "completed" : "NOT COMPLETED";
}

std::string bound(const FleetFigures& f) {
  if (f.bound.empty()) return "no lower bound known";
  return fmt::format("no plan ends before {:.2f} min (bound by {})", f.lower_bound_s / 60, f.bound);
}

std::string in_shared_air(const FleetFigures& f) {
  if (!f.planned_in_shared_air_s) return {};
  return fmt::format(" ({:.2f} taking off one by one)", *f.planned_in_shared_air_s / 60);
}

std::string minutes_or_none(std::optional<double> s) {
  return s ? fmt::format("{:.2f}", *s / 60) : "out of reach";
}

// What the plan was chosen from.
std::string yardstick_rows(const scheduler::Yardsticks& y) {
  return fmt::format(
      "{}; last cell otherwise:\n  shares of strips {}, till empty {}, simple {} min\n",
      y.is_joint ? "sorties chosen jointly" : "joint search found nothing faster",
      minutes_or_none(y.shares_s), minutes_or_none(y.till_empty_s), minutes_or_none(y.simple_s));
}

// How the return points were found, and how good they are where that is known.
std::string returns_row(const SolverFigures& s) {
  const std::string gap = s.gap ? fmt::format(", non-spray time {:.2f} % above {}", 100 * *s.gap,
                                              s.proven ? "the optimum" : "the bound")
                                : "";
  return fmt::format("return points by {}{}\n", s.returns, gap);
}

std::string makespan_rows(const Result& r) {
  return fmt::format("last {} {:.2f} min, planned {:.2f}{}\n{}\n", r.survey ? "visit" : "cell",
                     r.fleet.makespan_s / 60, r.fleet.planned_makespan_s / 60,
                     in_shared_air(r.fleet), bound(r.fleet));
}

std::string uav_rows(const Result& r) {
  std::string rows =
      fmt::format("{:>5} {:>7} {:>8} {:>8} {:>10} {:>11} {:>9} {:>10} {:>10}\n", "UAV", "strips",
                  "area ha", "sorties", "spray min", "non-spray", "wait min", "end min", "RMS cm");
  const std::size_t shown = std::min(r.uavs.size(), most_uav_rows);
  for (std::size_t i = 0; i < shown; ++i) {
    const UavFigures& u = r.uavs[i];
    rows += fmt::format(
        "{:>5} {:>7} {:>8.2f} {:>8} {:>10.1f} {:>11.1f} {:>9.1f} {:>10.1f} {:>10.1f}{}\n", u.id,
        u.strips, u.area_m2 / 10'000, u.sorties.size(), u.spray_s / 60, u.non_spray_s / 60,
        u.queue_wait_s / 60, u.spray_ended_s / 60, 100 * u.deviation.truth.rms_m,
        u.lost ? "  lost" : "");
  }
  if (shown < r.uavs.size()) rows += fmt::format("  ... and {} more\n", r.uavs.size() - shown);
  double area_m2 = 0;
  std::size_t sorties = 0;
  for (const UavFigures& u : r.uavs) {
    area_m2 += u.area_m2;
    sorties += u.sorties.size();
  }
  return rows + fmt::format(
                    "{:>5} {:>7} {:>8.2f} {:>8} {:>10.1f} {:>11.1f} {:>9.1f} {:>10.1f} {:>10.1f}\n",
                    "fleet", r.field.strips, area_m2 / 10'000, sorties, r.fleet.spray_s / 60,
                    r.fleet.non_spray_s / 60, r.fleet.queue_wait_s / 60, r.fleet.makespan_s / 60,
                    100 * r.deviation.truth.rms_m);
}

std::string work_done(const Result& r) {
  if (r.survey) {
    return fmt::format("visited {} of {} way points\n", r.survey->visited, r.survey->way_points);
  }
  std::string lines =
      fmt::format("covered {:.2f} ha, missed {:.0f} m2, repeated {:.0f} m2, outside {:.1f} m2\n",
                  r.coverage.covered_m2 / 10'000, r.coverage.missed_m2, r.coverage.repeated_m2,
                  r.coverage.outside_m2);
  lines += fmt::format("mix {:.1f} L at {:.2f} L/ha, {:.2f} L of it twice, {:.2f} L outside\n",
                       r.fleet.sprayed_l, r.fleet.rate_l_ha, r.fleet.repeated_l, r.fleet.outside_l);
  return lines;
}

// Empty where nobody came near to anybody.
std::string separation_row(const SeparationFigures& s) {
  if (s.encounters == 0) return {};
  return fmt::format(
      "two aircraft nearer than {:.1f} m {} times, {:.0f} s in all, the nearest {:.2f} m, first at "
      "{:.1f} s\n",
      s.distance_m, s.encounters, s.near_s, *s.closest_m, *s.first_s);
}

std::string clearance_row(const ClearanceFigures& c) {
  return cut(
      fmt::format("nearest to an obstacle: {:.2f} m, {:.0f} % of the safety distance, UAV {} "
                  "at {}",
                  c.least_m, 100 * c.share, c.uav, c.obstacle));
}

}  // namespace

std::string summary_table(const Result& r) {
  std::string table =
      cut(fmt::format("{} (seed {}): {}", r.scenario, r.seed, state(r))) + uav_rows(r);
  table += work_done(r);
  if (r.datum) {
    table += fmt::format("origin of the field frame: lat {:.7f}, lon {:.7f} (WGS84)\n",
                         r.datum->lat_deg, r.datum->lon_deg);
  }
  table += makespan_rows(r) + returns_row(r.solver);
  if (r.solver.yardsticks) table += yardstick_rows(*r.solver.yardsticks);
  table += separation_row(r.separation);
  if (r.clearance) table += clearance_row(*r.clearance);
  for (const ExpectationFigures& e : r.expectations) {
    if (!e.met) table += cut("missed: " + e.message);
  }
  for (const Violation& v : r.violations) {
    table += cut(fmt::format("broken: {} at {:.1f} s: {}", v.law, seconds(v.at).base(), v.detail));
  }
  return table;
}

std::string ProgressBar::draw(std::uint32_t sprayed_cells, double mission_s, double wall_s) {
  if (!on_tty_ || (drawn_s_ && wall_s - *drawn_s_ < redraw_s)) return {};
  drawn_s_ = wall_s;
  constexpr std::size_t width = 30;
  const double share = cells_ > 0 ? std::min(1.0, double{1} * sprayed_cells / cells_) : 1.0;
  const auto full = static_cast<std::size_t>(share * width);
  const double times_real = wall_s > 0 ? mission_s / wall_s : 0;
  // Erased to the end of the line, so that a shorter line leaves nothing of a longer one.
  return fmt::format("\r[{}{}] {:5.1f} % done  {:.1f} min  {:.0f} x real time\x1b[K",
                     std::string(full, '#'), std::string(width - full, '.'), 100 * share,
                     mission_s / 60, times_real);
}

std::string ProgressBar::clear() const { return drawn_s_ ? "\r\x1b[K" : ""; }

}  // namespace furrow::app
