#include "planner/fleet/by_station.hpp"

#include "planner/fleet/queue_clock.hpp"
#include "planner/fleet/till_empty.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace furrow::planner::fleet {
namespace {

/// Where on the path a station is nearest, of the ends of strips.
double passed_at_m(const FleetProblem& problem, const Depot& depot) {
  double least_m = std::numeric_limits<double>::infinity(), at_m = 0.0;
  for (std::uint32_t s = 1; s <= problem.path.strips(); ++s) {
    const double away_m = problem.path.back_m(depot.position, problem.path.begin_m(s));
    if (away_m >= least_m) continue;
    least_m = away_m;
    at_m = problem.path.begin_m(s);
  }
  return at_m;
}

struct Crew {
  std::uint32_t depot;
  std::vector<std::uint32_t> fliers;
  double passed_m, share;
};

std::vector<Crew> crews(const FleetProblem& problem) {
  std::vector<Crew> all;
  for (std::uint32_t d = 0; d < problem.depots.size(); ++d)
    all.push_back({d, {}, passed_at_m(problem, problem.depots[d]), 0.0});
  for (std::uint32_t u = 0; u < problem.fliers.size(); ++u) {
    const FieldPoint start = problem.fliers[u].start;
    auto& crew = *std::min_element(all.begin(), all.end(), [&](const Crew& a, const Crew& b) {
      return distance(problem.depots[a.depot].position, start) <
             distance(problem.depots[b.depot].position, start);
    });
    crew.fliers.push_back(u);
    crew.share += problem.fliers[u].spray_mps;
  }
  std::erase_if(all, [](const Crew& c) { return c.fliers.empty(); });
  std::stable_sort(all.begin(), all.end(),
                   [](const Crew& a, const Crew& b) { return a.passed_m < b.passed_m; });
  return all;
}

/// The strip's end if it is within a metre: no sliver of a strip is left over.
double snapped_m(const StripPath& path, double at_m) {
  const std::uint32_t s = path.strip_to(at_m);
  if (path.begin_m(s + 1) - at_m < 1.0) return path.begin_m(s + 1);
  if (at_m - path.begin_m(s) < 1.0) return path.begin_m(s);
  return at_m;
}

/// Nothing if one would be shorter than a metre.
std::vector<StationPart> parts(const FleetProblem& problem, const std::vector<Crew>& crews) {
  double shares = 0.0, taken = 0.0, from_m = 0.0;
  for (const Crew& c : crews) shares += c.share;
  std::vector<StationPart> all;
  all.reserve(crews.size());
  for (const Crew& c : crews) {
    taken += c.share;
    const bool last = &c == &crews.back();
    const double length_m = problem.path.length_m();
    const double to_m = last ? length_m : snapped_m(problem.path, length_m * taken / shares);
    if (to_m - from_m < 1.0) return {};
    StationPart part{{.path = problem.path.part(from_m, to_m),
                      .fliers = {},
                      .depots = {problem.depots[c.depot]},
                      .ends_sprayed = problem.ends_sprayed},
                     from_m,
                     c.depot,
                     c.fliers};
    for (const std::uint32_t u : c.fliers) part.problem.fliers.push_back(problem.fliers[u]);
    all.push_back(std::move(part));
    from_m = to_m;
  }
  return all;
}

}  // namespace

std::vector<StationPart> by_station(const FleetProblem& problem) {
  constexpr int rounds = 4;
  std::vector<Crew> all = crews(problem);
  if (all.size() < 2) return {};
  std::vector<StationPart> best;
  double best_s = std::numeric_limits<double>::infinity();
  for (int round = 0; round < rounds; ++round) {
    std::vector<StationPart> now = parts(problem, all);
    if (now.empty()) return best;
    double makespan_s = 0.0;
    for (std::size_t i = 0; i < now.size(); ++i) {
      const auto sorties = till_empty(now[i].problem);
      if (!sorties) return best;
      const double part_s = QueueClock{now[i].problem}.finish(*sorties).makespan_s;
      all[i].share /= part_s;
      makespan_s = std::max(makespan_s, part_s);
    }
    if (makespan_s >= best_s) continue;
    best_s = makespan_s;
    best = std::move(now);
  }
  return best;
}

FleetSorties of_whole(const FleetProblem& problem, const std::vector<StationPart>& parts,
                      const std::vector<FleetSorties>& sorties) {
  FleetSorties all;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (const Sortie& s : sorties[i]) {
      all.push_back({s.from_m + parts[i].from_m, s.to_m + parts[i].from_m, parts[i].fliers[s.flier],
                     parts[i].depot});
    }
  }
  // Positions were counted from other begins: they meet but for rounding.
  std::vector<Sortie*> along;
  along.reserve(all.size());
  for (Sortie& s : all) along.push_back(&s);
  std::sort(along.begin(), along.end(),
            [](const Sortie* a, const Sortie* b) { return a->from_m < b->from_m; });
  double at_m = 0.0;
  for (Sortie* s : along) {
    s->from_m = at_m;
    at_m = s->to_m;
  }
  along.back()->to_m = problem.path.length_m();
  return all;
}

}  // namespace furrow::planner::fleet
