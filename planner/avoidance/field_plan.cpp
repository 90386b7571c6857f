#include "planner/avoidance/field_plan.hpp"

#include "core/require.hpp"
#include "planner/avoidance/classic.hpp"
#include "planner/avoidance/field_options.hpp"
#include "planner/avoidance/genetic.hpp"
#include "planner/coverage/swath/inset.hpp"

#include <algorithm>
#include <cmath>

namespace furrow::planner {
namespace {

PointM plane(FieldPoint p) { return {p.x.base(), p.y.base()}; }
FieldPoint place(PointM p) { return at_m(p.x, p.y); }

std::vector<PassM> passes_of(const std::vector<StraightStrip>& strips) {
  std::vector<PassM> passes;
  for (const StraightStrip& s : strips) {
    passes.push_back({plane(s.from), plane(s.to), s.width.base()});
    require(passes.back().length_m() > 0 && s.width > Length{}, "a strip has length and width");
  }
  return passes;
}

// The part of `problem` that lies on one pass: its crowds are `first` to before `last`.
SelectionProblem on_pass(const SelectionProblem& problem, std::size_t first, std::size_t last) {
  SelectionProblem made = problem;
  made.crowds.assign(problem.crowds.begin() + static_cast<std::ptrdiff_t>(first),
                     problem.crowds.begin() + static_cast<std::ptrdiff_t>(last));
  made.interplays.clear();
  for (Interplay i : problem.interplays) {
    if (i.first < first || i.second >= last) continue;
    i.first -= first;
    i.second -= first;
    made.interplays.push_back(std::move(i));
  }
  return made;
}

double selections(const SelectionProblem& p) {
  double product = 1;
  for (const auto& options : p.crowds) product *= static_cast<double>(options.size());
  return product;
}

GeneticSettings genetic_settings(const AvoidanceSettings& s, std::uint64_t purpose) {
  return {.population = s.population,
          .iterations = s.iterations,
          .target_fitness = s.target_fitness,
          .seed = s.seed ^ purpose};
}

// Pass by pass; where a population would hold every selection, the best of all.
Selection pass_by_pass(const FieldOptions& field, const SelectionProblem& problem,
                       const AvoidanceSettings& s) {
  Selection made;
  const auto& crowds = field.crowds();
  for (std::size_t first = 0; first < crowds.size();) {
    std::size_t last = first;
    while (last < crowds.size() && crowds[last].pass == crowds[first].pass) ++last;
    SelectionProblem part = on_pass(problem, first, last);
    std::optional<Selection> best;
    if (selections(part) <= s.population) best = exact_selection(part);
    if (!best) {
      part.straight_m = field.passes()[crowds[first].pass].length_m();
      part.planned_m2 = part.straight_m * field.passes()[crowds[first].pass].width_m;
      best = genetic_selection(part, genetic_settings(s, crowds[first].pass + 1)).best;
    }
    made.insert(made.end(), best->begin(), best->end());
    first = last;
  }
  return made;
}

Selection always_closed(const FieldOptions& field) {
  Selection made;
  for (const PlacedCrowd& placed : field.crowds()) {
    std::size_t choice = 0;
    for (std::size_t o = 0; o < placed.crowd.options.size(); ++o) {
      if (placed.crowd.options[o].conduct != Conduct::sprayed) choice = o;
    }
    made.push_back(static_cast<std::uint16_t>(choice));
  }
  return made;
}

Selection selected(const FieldOptions& field, const SelectionProblem& problem,
                   const AvoidanceSettings& s, AvoidanceFigures& figures) {
  if (s.method == AvoidanceMethod::split) return always_closed(field);
  if (s.method == AvoidanceMethod::exact) {
    if (auto best = exact_selection(problem)) {
      figures.exact = true;
      return *best;
    }
  }
  const GeneticResult found =
      genetic_selection(problem, genetic_settings(s, 0), {pass_by_pass(field, problem, s)});
  figures.iterations = found.iterations;
  return found.best;
}

// Appends to the last stretch where that has the same valve and ends here.
void append(AvoidedStrip& strip, bool spraying, const PathM& path) {
  constexpr double same_m = 1e-6;
  if (path.size() < 2 || length_m(path) <= same_m) return;
  const bool goes_on = !strip.stretches.empty() && strip.stretches.back().spraying == spraying &&
                       norm(plane(strip.stretches.back().line.back()) - path.front()) <= same_m;
  if (!goes_on) strip.stretches.push_back({spraying, {place(path.front())}});
  std::vector<FieldPoint>& line = strip.stretches.back().line;
  for (std::size_t i = 1; i < path.size(); ++i) line.push_back(place(path[i]));
}

AvoidedStrip strip_around(const FieldOptions& field, std::size_t p, const Selection& chosen) {
  const PassM& pass = field.passes()[p];
  const auto along = [&](double at_m) {
    return pass.a + (at_m / pass.length_m()) * (pass.b - pass.a);
  };
  AvoidedStrip strip;
  PointM at = pass.a;
  for (std::size_t c = 0; c < field.crowds().size(); ++c) {
    if (field.crowds()[c].pass != p) continue;
    const CrowdOption& option = field.crowds()[c].crowd.options[chosen[c]];
    append(strip, true, {at, along(option.low_m)});
    if (option.conduct != Conduct::blocked) {
      PathM path = tangent_path(option.curve, corner_rad);
      path.front() = along(option.low_m);
      path.back() = along(option.high_m);
      append(strip, option.conduct == Conduct::sprayed, path);
    }
    at = along(option.high_m);
  }
  append(strip, true, {at, pass.b});
  return strip;
}

void set_areas(AvoidanceFigures& figures, const FieldOptions& field, const Room& room,
               const std::vector<FootprintM>& flown, double backswept_m2) {
  std::vector<RingM> rings;
  for (const BarrierM& barrier : room.barriers()) rings.push_back(barrier.ring);
  const WrongArea area = area_of(field.straight(), room.circles(), flown, rings);
  figures.missed = square_metres(area.missed_m2);
  figures.repeated = square_metres(area.repeated_m2 + backswept_m2);
}

// Half circles over what stands beside the line too, where one over a target would enter it.
PathM classic_path_clear(const PassM& pass, const Room& room) {
  std::vector<TargetM> targets = targets_of(pass, room);
  std::vector<bool> is_taken(room.circles().size(), false);
  for (;;) {
    PathM path = classic_path(pass, targets, ClassicSide::left);
    bool is_clear = true;
    for (const std::size_t i : room.entered(path)) {
      if (is_taken[i]) continue;
      is_taken[i] = true;
      is_clear = false;
      targets.push_back({{room.circles()[i]}});
    }
    if (is_clear) return path;
  }
}

// A barrier counts as the circle that holds it, as wide as its clearance and what chords of the
// half circle cut off.
Room with_barriers_as_circles(const Room& room) {
  constexpr double chords_m = 0.1;
  std::vector<CircleM> circles = room.circles();
  for (const BarrierM& barrier : room.barriers()) {
    const BoxM box = box_of(barrier.ring);
    CircleM& circle = circles.emplace_back();
    circle.center = 0.5 * (box.low + box.high);
    for (const PointM p : barrier.ring) {
      circle.radius_m = std::max(circle.radius_m, norm(p - circle.center));
    }
    circle.radius_m += barrier.clearance_m + chords_m;
  }
  return Room{std::move(circles), {}, {}};
}

// Where outlines are, half circles are large: they must keep clear, and inside the field.
bool is_flyable(const PathM& path, const Room& room) {
  constexpr std::size_t straight = 2;
  if (room.barriers().empty() || path.size() == straight) return true;
  return room.is_clear(path) && room.is_inside({path.begin() + 1, path.end() - 1});
}

// What is clear of the straight line, to a step.
std::vector<PathM> clear_parts(const PassM& pass, const Room& room) {
  constexpr double step_m = 0.1;
  const int steps = static_cast<int>(std::ceil(pass.length_m() / step_m));
  const auto at = [&](int step) {
    return pass.a + (static_cast<double>(step) / steps) * (pass.b - pass.a);
  };
  std::vector<PathM> parts;
  int first = 0;
  for (int step = 0; step <= steps; ++step) {
    if (step < steps && room.is_clear({at(step), at(step + 1)})) continue;
    if (step > first) parts.push_back({at(first), at(step)});
    first = step + 1;
  }
  return parts;
}

AvoidancePlan classic_plan(const FieldOptions& field, const Room& room, AvoidanceFigures figures) {
  AvoidancePlan plan{{}, figures};
  const Room round = with_barriers_as_circles(room);
  std::vector<FootprintM> flown;
  for (std::size_t p = 0; p < field.passes().size(); ++p) {
    const PassM& pass = field.passes()[p];
    std::vector<PathM> paths{classic_path_clear(pass, round)};
    const bool ends = !is_flyable(paths.front(), room);
    if (ends) {
      paths = clear_parts(pass, room);
    } else {
      plan.figures.extra += metres(length_m(paths.front()) - pass.length_m());
    }
    AvoidedStrip& strip = plan.strips.emplace_back();
    for (PathM& path : paths) {
      append(strip, true, path);
      flown.push_back({std::move(path), pass.width_m / 2});
    }
    for (const PlacedCrowd& crowd : field.crowds()) {
      if (crowd.pass == p) ++(ends ? plan.figures.blocked : plan.figures.detours);
    }
  }
  set_areas(plan.figures, field, room, flown, 0);
  return plan;
}

}  // namespace

Field without_led_around(Field field, const std::vector<std::size_t>& ends_rows) {
  std::vector<Obstacle> kept;
  kept.reserve(ends_rows.size());
  for (const std::size_t i : ends_rows) kept.push_back(std::move(field.obstacles.at(i)));
  field.obstacles = std::move(kept);
  return field;
}

std::vector<Obstacle> led_around(const Field& field, const std::vector<std::size_t>& ends_rows) {
  std::vector<Obstacle> led;
  for (std::size_t i = 0; i < field.obstacles.size(); ++i) {
    const bool ends = std::find(ends_rows.begin(), ends_rows.end(), i) != ends_rows.end();
    if (!ends) led.push_back(field.obstacles[i]);
  }
  return led;
}

Expected<Room, PlanError> room_of(const Field& field, Length margin, Length hole_buffer,
                                  Length safety, const std::vector<std::size_t>& ends_rows) {
  auto land = field_land(without_led_around(field, ends_rows), margin, hole_buffer, safety);
  if (!land) return Unexpected{land.error()};
  std::vector<CircleM> circles;
  std::vector<BarrierM> barriers;
  for (const Obstacle& o : led_around(field, ends_rows)) {
    if (o.outline.empty()) {
      circles.push_back({plane(o.center), (o.radius + safety).base()});
      continue;
    }
    BarrierM& barrier = barriers.emplace_back();
    for (const FieldPoint p : o.outline) barrier.ring.push_back(plane(p));
    barrier.clearance_m = safety.base();
  }
  return Room{std::move(circles), std::move(barriers),
              moved(std::move(land->flight), land->origin)};
}

AvoidancePlan plan_avoidance(const std::vector<StraightStrip>& strips, const Room& room,
                             const AvoidanceSettings& s) {
  const FieldOptions field{passes_of(strips), room, s.turn_radius.base()};
  AvoidanceFigures figures;
  figures.targets = field.targets();
  figures.crowds = field.crowds().size();
  for (const PassM& pass : field.passes()) figures.straight += metres(pass.length_m());
  if (s.method == AvoidanceMethod::classic) return classic_plan(field, room, figures);

  AvoidancePlan plan;
  Selection chosen;
  if (!strips.empty()) {
    const SelectionProblem problem = field.problem(s.length_weight, s.area_weight);
    chosen = selected(field, problem, s, figures);
    figures.fitness = fitness(problem, chosen);
  }
  std::vector<FootprintM> flown;
  for (std::size_t p = 0; p < strips.size(); ++p) {
    plan.strips.push_back(strip_around(field, p, chosen));
    for (FootprintM& f : field.flown(p, chosen)) flown.push_back(std::move(f));
  }
  for (std::size_t c = 0; c < chosen.size(); ++c) {
    const CrowdOption& option = field.crowds()[c].crowd.options[chosen[c]];
    figures.extra += metres(option.extra_m);
    ++(option.conduct == Conduct::sprayed  ? figures.detours
       : option.conduct == Conduct::closed ? figures.closed
                                           : figures.blocked);
  }
  set_areas(figures, field, room, flown, field.backswept_m2(chosen));
  plan.figures = figures;
  return plan;
}

}  // namespace furrow::planner
