#include "planner/coverage/swath/part_plan.hpp"

#include "planner/at_once.hpp"
#include "planner/coverage/swath/cells.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace furrow::planner {
namespace {

constexpr int searched_degrees = 180;
constexpr std::size_t per_batch = 24;    // directions ranked by one thread
constexpr std::size_t most_edges = 8;    // whose directions are tried
constexpr std::size_t most_planned = 3;  // directions planned in full
constexpr std::size_t most_cut = 4;      // directions along which cells are cut
constexpr std::size_t most_cells = 12;
constexpr double steepest_extension = 5.0;  // cotangent of the flattest edge that rows run past

SweepRule sweep_rule(const PlanRule& rule) {
  return {.swath_m = rule.swath_m,
          .edge_gap_m = std::max(0.0, rule.swath_m / 2 - rule.margin_m),
          .edges = rule.settings.edges,
          .last_row = rule.settings.last_row,
          .min_strip_m = rule.settings.min_strip.base()};
}

double rows_cost_m(const Sweep& rows, const PlanRule& rule) {
  double sum = 0;
  for (const Chord& chord : rows.chords) sum += chord.length_m();
  return sum +
         static_cast<double>(rows.chords.size()) * (rule.settings.turn_cost.base() + rule.swath_m);
}

constexpr double across_edges = 1.01;  // the price of rows along no edge

double missing_cost_m(double missed_m2, const PlanRule& rule) {
  return 2 * missed_m2 / rule.swath_m;
}

// Rows that stay inside leave land out at their ends; others, what is dropped.
double missed_m2(const LandPart& land, double sprayed_m, double dropped_m2, const PlanRule& rule) {
  if (rule.settings.edges == EdgeMode::cover_all) return dropped_m2;
  return std::max(0.0, area_m2(land) - sprayed_m * rule.swath_m);
}

// Rows, turns, how ragged their ends are, and a swath for every second group on a row.
double coarse_cost_m(const LandPart& piece, RowFrame frame, const PlanRule& rule) {
  const Sweep rows = sweep(piece, {piece}, frame, sweep_rule(rule));
  std::size_t leaps = 0;
  for (std::size_t i = 1; i < rows.chords.size(); ++i) {
    if (rows.chords[i].row == rows.chords[i - 1].row) ++leaps;
  }
  double ends_m = 0;  // how far ends of neighbouring rows lie apart along the rows
  for (std::size_t i = 1; i < rows.chords.size(); ++i) {
    ends_m += std::abs(rows.chords[i].low_m - rows.chords[i - 1].low_m) +
              std::abs(rows.chords[i].high_m - rows.chords[i - 1].high_m);
  }
  const double chords = static_cast<double>(rows.chords.size());
  double sprayed_m = 0;
  for (const Chord& chord : rows.chords) sprayed_m += chord.length_m();
  const double left_out_m2 = missed_m2(piece, sprayed_m, rows.dropped_m2, rule);
  return rows_cost_m(rows, rule) + missing_cost_m(left_out_m2, rule) + ends_m / 2 +
         std::min<double>(static_cast<double>(leaps), chords) * rule.swath_m;
}

// Of rows along each direction on all pieces.
std::vector<double> coarse_costs_m(const LandParts& pieces, const std::vector<RowDirection>& tried,
                                   const PlanRule& rule) {
  const auto batch = [&](std::size_t b) {
    std::vector<double> costs;
    costs.reserve(per_batch);
    for (std::size_t i = b * per_batch; i < std::min(tried.size(), (b + 1) * per_batch); ++i) {
      double cost = 0;
      for (const LandPart& piece : pieces) cost += coarse_cost_m(piece, tried[i].frame, rule);
      costs.push_back(tried[i].along_edge ? cost : across_edges * cost);
    }
    return costs;
  };
  std::vector<double> all;
  for (const auto& costs : at_once((tried.size() + per_batch - 1) / per_batch, batch)) {
    all.insert(all.end(), costs.begin(), costs.end());
  }
  return all;
}

PointM end_of(const Sweep& rows, const Chord& chord, bool high) {
  return rows.frame.from({high ? chord.high_m : chord.low_m, rows.rows[chord.row].v_m});
}

// Where rows end at a cut and not at the edge of the flight area, runs them on until their whole
// width has crossed the cut.
void run_past_cuts(Sweep& rows, const LandPart& piece, const LandPart& flight,
                   const EdgeGrid& edges) {
  std::vector<double> slope;  // of each edge of the piece, along per across
  each_edge(piece, [&](PointM a, PointM b) {
    const PointM along = rows.frame.to(b) - rows.frame.to(a);
    slope.push_back(along.y == 0 ? INFINITY : std::abs(along.x / along.y));
  });
  for (Chord& chord : rows.chords) {
    for (const bool high : {false, true}) {
      const auto edge = static_cast<std::size_t>(high ? chord.right_edge : chord.left_edge);
      if (slope[edge] < 1e-6 || slope[edge] > steepest_extension) continue;
      const PointM end = end_of(rows, chord, high);
      if (edges.edge_at(end)) continue;
      const double more_m = slope[edge] * rows.rows[chord.row].half_width_m;
      double& place = high ? chord.high_m : chord.low_m;
      const double wanted = high ? place + more_m : place - more_m;
      const Row line = rows.rows[chord.row];
      for (const Chord& room : chords_at(flight, {}, rows.frame, line, EdgeMode::cover_all)) {
        if (room.low_m <= place && place <= room.high_m) {
          place = std::clamp(wanted, room.low_m, room.high_m);
          break;
        }
      }
    }
  }
}

void add_groups(PartPlan& plan, const LandPart& piece, const LandPart& flight,
                const LandParts& land, const EdgeGrid& edges, RowFrame direction,
                const PlanRule& rule, bool is_cut) {
  SweepRule numbers = sweep_rule(rule);
  if (is_cut) numbers.edge_gap_m = rule.swath_m / 2;
  Sweep rows = sweep(piece, land, direction, numbers);
  if (is_cut && rule.settings.edges == EdgeMode::cover_all) {
    run_past_cuts(rows, piece, flight, edges);
  }
  plan.dropped_m2 += rows.dropped_m2;
  for (StripGroup& group : strip_groups(rows, rule.swath_m)) {
    plan.groups.push_back(std::move(group));
  }
}

RowFrame best_in_cell(const LandPart& cell, RowFrame cut_along, const PlanRule& rule) {
  std::vector<RowFrame> tried = edge_directions(cell, most_edges);
  tried.insert(tried.begin(), cut_along);
  RowFrame best = cut_along;
  double least_m = INFINITY;
  for (const RowFrame frame : tried) {
    const double cost = coarse_cost_m(cell, frame, rule);
    if (cost < least_m - 1e-9) {
      least_m = cost;
      best = frame;
    }
  }
  return best;
}

PartPlan plan_cells(const LandParts& cells, const LandPart& flight, const LandParts& land,
                    const InsidePaths& paths, RowDirection cut, const PlanRule& rule,
                    const std::vector<StripGroup>& first) {
  PartPlan plan{.groups = first, .order = {}, .along_edge = cut.along_edge};
  double largest_m2 = 0;
  for (const LandPart& cell : cells) {
    const RowFrame direction = best_in_cell(cell, cut.frame, rule);
    if (area_m2(cell) > largest_m2) {
      largest_m2 = area_m2(cell);
      plan.direction = direction;
    }
    add_groups(plan, cell, flight, land, paths.edges(), direction, rule, true);
  }
  put_in_order(plan, flight, paths, rule);
  return plan;
}

}  // namespace

void put_in_order(PartPlan& plan, const LandPart& flight, const InsidePaths& paths,
                  const PlanRule& rule) {
  plan.order = strip_order(plan.groups, paths, rule.start);
  double sprayed_m = 0;
  for (const OrderedStrip& s : plan.order.strips) sprayed_m += norm(s.strip.b - s.strip.a);
  plan.missed_m2 = missed_m2(flight, sprayed_m, plan.dropped_m2, rule);
}

double cost_m(const PartPlan& plan, const PlanRule& rule) {
  const double turns_m =
      rule.settings.turn_cost.base() * static_cast<double>(plan.order.strips.size());
  const double flown_m = plan.order.route_m + turns_m + missing_cost_m(plan.missed_m2, rule);
  return plan.along_edge ? flown_m : across_edges * flown_m;
}

std::vector<RowDirection> ranked_directions(const LandParts& pieces, const PlanRule& rule,
                                            std::size_t most) {
  std::vector<RowDirection> tried;
  for (const LandPart& piece : pieces) {
    for (const RowFrame frame : edge_directions(piece, most_edges)) tried.push_back({frame, true});
  }
  for (int degree = 0; degree < searched_degrees; ++degree) {
    const double angle = degree * std::numbers::pi / 180;
    tried.push_back({{std::cos(angle), std::sin(angle)}, false});
  }
  const std::vector<double> costs = coarse_costs_m(pieces, tried, rule);
  std::vector<std::pair<double, RowDirection>> ranked;
  ranked.reserve(tried.size());
  for (std::size_t i = 0; i < tried.size(); ++i) ranked.push_back({costs[i], tried[i]});
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<RowDirection> best;
  for (std::size_t i = 0; i < std::min(most, ranked.size()); ++i) {
    best.push_back(ranked[i].second);
  }
  return best;
}

PartPlan plan_one_direction(const LandPart& piece, const LandPart& flight, const LandParts& land,
                            const InsidePaths& paths, RowDirection direction, const PlanRule& rule,
                            const std::vector<StripGroup>& first) {
  PartPlan plan{.groups = first,
                .order = {},
                .direction = direction.frame,
                .along_edge = direction.along_edge};
  add_groups(plan, piece, flight, land, paths.edges(), direction.frame, rule, !first.empty());
  put_in_order(plan, flight, paths, rule);
  return plan;
}

std::vector<PartPlan> ranked_plans(const LandPart& piece, const LandPart& flight,
                                   const LandParts& land, const InsidePaths& paths,
                                   const PlanRule& rule, const std::vector<StripGroup>& first) {
  std::vector<PartPlan> plans;
  const std::vector<RowDirection> directions = ranked_directions({piece}, rule, most_planned);
  plans.reserve(directions.size());
  for (const RowDirection direction : directions) {
    plans.push_back(plan_one_direction(piece, flight, land, paths, direction, rule, first));
  }
  const EdgeGrid edges{piece};
  std::vector<RowDirection> cuts;
  for (const RowFrame along : edge_directions(piece, most_cut)) cuts.push_back({along, true});
  cuts.push_back(directions.front());
  for (const RowDirection cut : cuts) {
    const LandParts cells = row_cells(piece, edges, cut.frame);
    if (cells.size() < 2 || cells.size() > most_cells) continue;
    plans.push_back(plan_cells(cells, flight, land, paths, cut, rule, first));
  }
  std::stable_sort(plans.begin(), plans.end(), [&](const PartPlan& a, const PartPlan& b) {
    return cost_m(a, rule) < cost_m(b, rule);
  });
  return plans;
}

}  // namespace furrow::planner
