#include "app/results/report/tables.hpp"

#include "app/results/report/html_table.hpp"

#include <map>

namespace furrow::app {
namespace {

std::string minutes(double t_s) { return fmt::format("{:.1f}", t_s / 60); }
std::string minutes2(double t_s) { return fmt::format("{:.2f}", t_s / 60); }
std::string whole(double value) { return fmt::format("{:.0f}", value + 0.0); }
std::string percent(double share) { return fmt::format("{:.2f} %", 100 * share); }
std::string centimetres(double length_m) { return fmt::format("{:.1f}", 100 * length_m); }
std::string place(FieldPoint p) { return fmt::format("{:.1f}, {:.1f}", p.x.base(), p.y.base()); }

std::string area(double m2) {
  return m2 >= 10'000 ? fmt::format("{:.2f} ha", m2 / 10'000) : fmt::format("{:.0f} m²", m2);
}

std::string card(std::string_view label, const std::string& value, const std::string& note,
                 std::string_view style = {}) {
  return fmt::format("<div class=\"card {}\"><b>{}</b><strong>{}</strong><span>{}</span></div>",
                     style, escaped(label), escaped(value), escaped(note));
}

std::string makespan_note(const Result& r) {
  if (r.mode == Mode::plan && !(r.fleet.lower_bound_s > 0)) return "no bound known";
  if (r.mode == Mode::plan) return "at best " + minutes(r.fleet.lower_bound_s) + " min";
  const double planned_s = r.fleet.planned_makespan_s;
  const double off = planned_s > 0 ? 100 * (r.fleet.makespan_s / planned_s - 1) : 0;
  return fmt::format("planned {} ({:+.1f} %)", minutes(planned_s), off);
}

// How far the search was from the bound before it was refined.
std::string gsa_alone(const SolverFigures& s) {
  if (!s.gsa_s || !(s.lower_bound_s > 0)) return {};
  return "; GSA alone " + percent(*s.gsa_s / s.lower_bound_s - 1);
}

// By the non-spray time of the plan, else by its last cell.
std::string gap_card(const Result& r) {
  if (r.solver.gap) {
    return card(r.solver.proven ? "Above the optimum" : "Above the bound", percent(*r.solver.gap),
                "non-spray time of the plan" + gsa_alone(r.solver));
  }
  if (r.fleet.lower_bound_s > 0) {
    return card("Above the bound", percent(r.fleet.planned_makespan_s / r.fleet.lower_bound_s - 1),
                "last cell of the plan; bound by " + r.fleet.bound);
  }
  return card("Optimality gap", "not known", "no bound is known for this plan");
}

std::string laws_card(const Result& r) {
  return card("Laws broken", fmt::format("{}", r.violations.size()),
              fmt::format("in {} messages", r.log.messages), r.violations.empty() ? "good" : "bad");
}

std::string survey_headline(const Result& r) {
  const bool is_flown = r.mode != Mode::plan;
  const SurveyFigures& s = *r.survey;
  std::string cards = "<div class=\"cards\">";
  cards +=
      card(is_flown ? "Visited" : "To visit", fmt::format("{}", s.visited),
           fmt::format("of {} way points", s.way_points), s.visited < s.way_points ? "bad" : "");
  cards += card("Last visit", minutes(r.fleet.makespan_s) + " min", makespan_note(r));
  cards += card("Flown between visits", fmt::format("{:.2f} km", r.fleet.route_m / 1000),
                fmt::format("{} battery swaps", r.solver.swaps));
  cards += card("Aircraft", fmt::format("{}", r.uavs.size()),
                minutes(r.fleet.queue_wait_s) + " min waiting for a bay");
  if (is_flown) cards += laws_card(r);
  return cards + "</div>";
}

// Beyond the plan, of what is workable, before a report sets it off.
constexpr double may_miss_share = 0.001, may_repeat_share = 0.01;

std::string flown_cards(const Result& r, double workable_m2) {
  const double planned_twice_m2 = r.sweep ? r.sweep->areas.repeated.base() : 0;
  const bool is_off = r.coverage.repeated_m2 > planned_twice_m2 + may_repeat_share * workable_m2;
  return card("Off the line", centimetres(r.deviation.truth.rms_m) + " cm",
              "RMS; " + centimetres(r.deviation.truth.max_m) + " cm at most") +
         card("Sprayed twice", area(r.coverage.repeated_m2),
              fmt::format("{} in the plan; {:.1f} L; {} ({:.1f} L) outside the field",
                          area(planned_twice_m2), r.fleet.repeated_l, area(r.coverage.outside_m2),
                          r.fleet.outside_l),
              is_off ? "bad" : "") +
         laws_card(r);
}

std::string planned_cards(const Result& r) {
  std::size_t sorties = 0;
  for (const UavFigures& uav : r.uavs) sorties += uav.sorties.size();
  return card("Sorties", fmt::format("{}", sorties),
              fmt::format("{} battery swaps", r.solver.swaps)) +
         card("Ferrying", fmt::format("{:.1f} km", r.fleet.ferry_m / 1000),
              fmt::format("{:.1f} km at work", r.fleet.route_m / 1000)) +
         card("Aircraft", fmt::format("{}", r.uavs.size()),
              fmt::format("{} stations", r.stations.size()));
}

}  // namespace

std::string headline(const Result& r) {
  if (r.survey) return survey_headline(r);
  const double workable_m2 = r.coverage.covered_m2 + r.coverage.missed_m2;
  const double covered = workable_m2 > 0 ? r.coverage.covered_m2 / workable_m2 : 0;
  const bool is_flown = r.mode != Mode::plan;
  std::string cards = "<div class=\"cards\">";
  cards += card(is_flown ? "Sprayed" : "To spray", area(r.coverage.covered_m2),
                fmt::format("{} of what is workable; {:.1f} L at {:.1f} L/ha", percent(covered),
                            r.fleet.sprayed_l, r.fleet.rate_l_ha));
  const double most_m2 = r.coverage.unrouted_m2 + may_miss_share * workable_m2;
  cards += card("Missed", area(r.coverage.missed_m2), area(r.coverage.unrouted_m2) + " in the plan",
                r.coverage.missed_m2 > most_m2 ? "bad" : "");
  cards += card("Last cell sprayed", minutes(r.fleet.makespan_s) + " min", makespan_note(r));
  cards += card("Not spraying", minutes(r.fleet.non_spray_s) + " min",
                minutes(r.fleet.queue_wait_s) + " min of it waiting for a bay");
  cards += gap_card(r);
  return cards + (is_flown ? flown_cards(r, workable_m2) : planned_cards(r)) + "</div>";
}

std::string coverage_table(const Result& r) {
  if (!r.sweep) return {};
  const planner::SweepFigures& s = *r.sweep;
  HtmlTable table{"<", "Planned", r.mode == Mode::plan ? "" : "Flown"};
  const auto row = [&](const char* what, Area planned, double flown_m2) {
    table.row({what, whole(planned.base()), r.mode == Mode::plan ? "" : whole(flown_m2)});
  };
  row("Covered, m2", s.areas.covered, r.coverage.covered_m2);
  row("Missed, m2", s.areas.missed, r.coverage.missed_m2);
  row("Repeated, m2", s.areas.repeated, r.coverage.repeated_m2);
  row("Outside, m2", s.areas.outside, r.coverage.outside_m2);
  return table.markup("narrow") +
         fmt::format(
             "<p class=\"note\">Areas are of true footprints. {} strip{} in {} part{} of the "
             "field, {:.0f} m sprayed, {:.0f} m with the connections inside the field; no "
             "order of these rows is shorter than {:.0f} m ({}). Short strips left out: "
             "{:.0f} m2.</p>",
             r.field.strips, r.field.strips == 1 ? "" : "s", s.parts, s.parts == 1 ? "" : "s",
             s.sprayed.base(), s.route.base(), s.order_bound.base(),
             s.order_exact ? "solved exactly" : "a bound", s.dropped.base());
}

std::string expectation_table(const Result& r) {
  HtmlTable table{"<Figure", "Value", "At least", "At most", "<Met"};
  const auto bound = [](const std::optional<double>& v) {
    return v ? fmt::format("{}", *v) : std::string{};
  };
  for (const ExpectationFigures& e : r.expectations) {
    table.row({e.key, e.value ? fmt::format("{:.6g}", *e.value) : "none", bound(e.min),
               bound(e.max), e.met ? "✓ met" : "✗ missed"},
              e.met ? "good" : "bad");
  }
  return table.empty() ? "" : table.markup("narrow");
}

namespace {

// Last cells of the plans that the plan was chosen from.
void add_yardsticks(HtmlTable& table, const scheduler::Yardsticks& y) {
  const auto row = [&](std::string label, std::optional<double> makespan_s) {
    table.row({std::move(label), makespan_s ? minutes2(*makespan_s) : "out of reach", "", ""});
  };
  row("The same by shares of strips, min", y.shares_s);
  row("The same till empty, min", y.till_empty_s);
  row("The same by the simple plan, min", y.simple_s);
}

}  // namespace

std::string optimum_table(const Result& r) {
  const SolverFigures& s = r.solver;
  const bool is_bounded = r.fleet.lower_bound_s > 0;
  HtmlTable table{"<", "Plan", s.proven ? "Optimum" : "No plan is below", "Gap"};
  table.row({"Return points", fmt::format("{}", s.return_points), "", ""});
  table.row({"Round trips, m", whole(s.round_trips_m), "", ""});
  table.row({"Battery swaps", fmt::format("{}", s.swaps), "", ""});
  table.row({"Filling, min", minutes2(s.fill_s), "", ""});
  table.row({"Service, min", minutes2(s.service_s), "", ""});
  table.row({"Non-spray time, min", minutes2(s.non_spray_s), s.gap ? minutes2(s.lower_bound_s) : "",
             s.gap ? percent(*s.gap) : "no bound known"},
            "total");
  if (s.until_empty_s && *s.until_empty_s > 0) {
    table.row({"The same until empty, min", minutes2(*s.until_empty_s), "",
               fmt::format("{:+.2f} %", 100 * (s.non_spray_s / *s.until_empty_s - 1))});
  }
  if (s.anywhere_lower_bound_s) {
    table.row({"Returning anywhere on a strip, min", "", minutes2(*s.anywhere_lower_bound_s),
               fmt::format("{:.3f} % of the mission", 100 * *s.anywhere_gap)});
  }
  if (s.gsa_s) table.row({"Objective of GSA alone, min", minutes2(*s.gsa_s), "", ""});
  table.row({r.fleet.bound.empty() ? "Last cell, min"
                                   : fmt::format("Last cell, min (bound by {})", r.fleet.bound),
             minutes2(r.fleet.planned_makespan_s),
             is_bounded ? minutes2(r.fleet.lower_bound_s) : "",
             is_bounded ? percent(r.fleet.planned_makespan_s / r.fleet.lower_bound_s - 1)
                        : "no bound known"});
  if (s.yardsticks) add_yardsticks(table, *s.yardsticks);
  return table.markup("narrow") +
         fmt::format(
             "<p class=\"note\">Return points by {}{}, {} evaluations. Non-spray time is round "
             "trips and services without waits, the last way home left out.</p>",
             escaped(s.returns), s.refined ? " and refinement" : "", s.evaluations);
}

std::string uav_table(const Result& r) {
  HtmlTable table{
      "UAV", "Strips",  "Area, ha",    "Sorties",          "Non-spray plan, min", "Bound, min",
      "Gap", "<Proven", "Waited, min", "Planned end, min", "Last cell, min",      "Ferried, km"};
  for (const UavFigures& u : r.uavs) {
    const bool is_bounded = u.lower_bound_s > 0 || u.planned_non_spray_s == 0;
    const double over = u.lower_bound_s > 0 ? u.planned_non_spray_s / u.lower_bound_s - 1 : 0;
    table.row({fmt::format("{}{}", u.id, u.lost ? " ✗ lost" : ""), fmt::format("{}", u.strips),
               fmt::format("{:.2f}", u.area_m2 / 10'000), fmt::format("{}", u.sorties.size()),
               minutes2(u.planned_non_spray_s), is_bounded ? minutes2(u.lower_bound_s) : "",
               is_bounded ? percent(over) : "", u.proven ? "yes" : "no", minutes(u.queue_wait_s),
               minutes(u.planned_spray_ended_s), minutes(u.spray_ended_s),
               fmt::format("{:.1f}", u.ferry_m / 1000)},
              u.lost ? "bad" : "");
  }
  return table.markup();
}

std::string deviation_table(const Result& r) {
  if (r.deviation.truth.samples == 0) return {};
  HtmlTable table{
      "<",      "True RMS, cm", "True largest, cm", "RMS by the fix, cm", "Largest by the fix, cm",
      "Samples"};
  const auto row = [&](const std::string& who, const DeviationFigures& d, std::string_view style) {
    table.row(
        {who, centimetres(d.truth.rms_m), centimetres(d.truth.max_m), centimetres(d.fix.rms_m),
         centimetres(d.fix.max_m), fmt::format("{}", d.truth.samples)},
        style);
  };
  for (const UavFigures& u : r.uavs) row(fmt::format("UAV {}", u.id), u.deviation, "");
  row("Fleet", r.deviation, "total");
  return table.markup("narrow") +
         fmt::format(
             "<p class=\"note\">From the true tracks: {} wetted, {} of workable land left "
             "dry, {} wetted again, {} outside the field; flown outside: {:.0f} m.</p>",
             area(r.footprint.wetted_m2), area(r.footprint.missed_m2), area(r.footprint.overlap_m2),
             area(r.footprint.outside_m2), r.fleet.flown_outside_m);
}

std::string sortie_table(const Result& r) {
  HtmlTable table{"UAV",        "Sortie",        "Began, min",  "Start, m", "Return, m",
                  "Sprayed, m", "Round trip, m", "Flight, min", "Pack",     "Used",
                  "Waited, s",  "Swap, s",       "Fill, s",     "Station",  "Bay"};
  for (const UavFigures& u : r.uavs) {
    std::size_t number = 0;
    for (const SortieFigures& s : u.sorties) {
      const bool is_served = s.bay > 0;
      table.row({fmt::format("{}", u.id), fmt::format("{}", ++number), minutes(s.began_s),
                 place(s.start), place(s.returned), whole(s.spray_m),
                 is_served ? fmt::format("{:.1f}", s.round_trip_m) : "", minutes(s.flight_s),
                 fmt::format("{}", s.pack), fmt::format("{:.1f} %", 100 * s.battery_used),
                 is_served ? whole(s.wait_s) : "", is_served ? whole(s.battery_swap_s) : "",
                 is_served ? whole(s.fill_s) : "", is_served ? fmt::format("{}", s.station) : "",
                 is_served ? fmt::format("{}", s.bay) : ""});
    }
  }
  return table.empty() ? "" : table.markup("tight");
}

std::string battery_table(const Result& r) {
  std::map<std::uint32_t, std::string> by_uav;
  for (const BatteryFigures& b : r.batteries) {
    std::string& packs = by_uav[b.uav];
    packs += fmt::format("{}{:.1f}", packs.empty() ? "" : " · ", 100 * b.used);
  }
  HtmlTable table{"UAV", "<Used of each pack, %"};
  for (const auto& [uav, packs] : by_uav) table.row({fmt::format("{}", uav), packs});
  return table.empty() ? "" : table.markup();
}

std::string station_table(const Result& r) {
  HtmlTable table{"<Station", "Swaps",     "Filled, L",
                  "Services", "Busy, min", "Share of the mission"};
  for (const StationFigures& s : r.stations) {
    double busy_s = 0;
    std::uint32_t services = 0;
    for (const BayFigures& b : s.bays) {
      busy_s += b.busy_s;
      services += b.services;
    }
    const double open_s = r.fleet.makespan_s * static_cast<double>(s.bays.size());
    table.row({fmt::format("Station\u00a0{}", s.id), fmt::format("{}", s.swaps),
               fmt::format("{:.1f}", s.filled_l), fmt::format("{}", services), minutes(busy_s),
               open_s > 0 ? percent(busy_s / open_s) : ""},
              "total");
    for (const BayFigures& b : s.bays) {
      table.row({fmt::format("bay {}", b.bay), "", "", fmt::format("{}", b.services),
                 minutes(b.busy_s),
                 r.fleet.makespan_s > 0 ? percent(b.busy_s / r.fleet.makespan_s) : ""});
    }
  }
  return table.empty() ? "" : table.markup();
}

}  // namespace furrow::app
