#include "planner/coverage/swath/order.hpp"

#include "planner/coverage/swath/group_ways.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace furrow::planner {
namespace {

constexpr std::size_t most_exact = 9;    // groups
constexpr int most_rounds = 40;          // of improvement
constexpr std::size_t longest_move = 3;  // groups moved at once
constexpr double gain_m = 1e-9;          // less is rounding
constexpr std::size_t senses = GroupWays::senses;

struct Step {
  std::size_t group, sense;
};
using Tour = std::vector<Step>;

double way_m(const GroupWays& ways, Step from, Step to) {
  return ways.way_m(from.group, from.sense, to.group, to.sense);
}
double straight_m(const GroupWays& ways, Step from, Step to) {
  return ways.straight_m(from.group, from.sense, to.group, to.sense);
}
Step reversed(const GroupWays& ways, Step s) { return {s.group, ways.reversed(s.group, s.sense)}; }

Tour exact_tour(const GroupWays& ways) {
  const std::size_t n = ways.size(), states = n * senses, sets = std::size_t{1} << n;
  std::vector<double> best(sets * states, INFINITY);
  std::vector<std::size_t> before(sets * states, states);
  for (std::size_t state = 0; state < states; ++state) {
    const std::size_t g = state / senses, s = state % senses;
    if (ways.allows(g, s)) {
      best[(std::size_t{1} << g) * states + state] = ways.first_m(g, s) + ways.turns_m(g, s);
    }
  }
  for (std::size_t set = 1; set < sets; ++set) {
    for (std::size_t state = 0; state < states; ++state) {
      const double here = best[set * states + state];
      if (here == INFINITY) continue;
      for (std::size_t next = 0; next < states; ++next) {
        const std::size_t g = next / senses, s = next % senses;
        if ((set >> g & 1) != 0 || !ways.allows(g, s)) continue;
        const double length =
            here + ways.turns_m(g, s) + ways.way_m(state / senses, state % senses, g, s);
        const std::size_t slot = (set | std::size_t{1} << g) * states + next;
        if (length < best[slot]) {
          best[slot] = length;
          before[slot] = state;
        }
      }
    }
  }
  const auto full = best.begin() + static_cast<std::ptrdiff_t>((sets - 1) * states);
  auto state = static_cast<std::size_t>(
      std::min_element(full, full + static_cast<std::ptrdiff_t>(states)) - full);
  Tour tour;
  for (std::size_t set = sets - 1; set != 0;) {
    tour.push_back({state / senses, state % senses});
    const std::size_t from = before[set * states + state];
    set &= ~(std::size_t{1} << state / senses);
    state = from;
  }
  std::reverse(tour.begin(), tour.end());
  return tour;
}

// The next group not yet flown with the shortest way and turns; straight distances rule most out
// before a way is searched.
Step nearest(const GroupWays& ways, const Tour& tour, const std::vector<bool>& flown) {
  Step best{0, 0};
  double best_m = INFINITY;
  for (std::size_t g = 0; g < ways.size(); ++g) {
    if (flown[g]) continue;
    for (std::size_t s = 0; s < senses; ++s) {
      if (!ways.allows(g, s)) continue;
      const Step step{g, s};
      const double least_m =
          tour.empty() ? ways.first_m(g, s) : straight_m(ways, tour.back(), step);
      if (least_m >= best_m) continue;
      const double length_m = tour.empty() ? least_m : way_m(ways, tour.back(), step);
      if (length_m < best_m) {
        best_m = length_m;
        best = step;
      }
    }
  }
  return best;
}

Tour nearest_tour(const GroupWays& ways) {
  Tour tour;
  std::vector<bool> flown(ways.size(), false);
  while (tour.size() < ways.size()) {
    tour.push_back(nearest(ways, tour, flown));
    flown[tour.back().group] = true;
  }
  return tour;
}

// The link from the step before `at` (the start, if none) to `to`.
double link_m(const GroupWays& ways, const Tour& tour, std::size_t at, Step to) {
  return at == 0 ? ways.first_m(to.group, to.sense) : way_m(ways, tour[at - 1], to);
}
double least_link_m(const GroupWays& ways, const Tour& tour, std::size_t at, Step to) {
  return at == 0 ? ways.first_m(to.group, to.sense) : straight_m(ways, tour[at - 1], to);
}

bool has_fixed(const GroupWays& ways, const Tour& tour, std::size_t first, std::size_t last) {
  for (std::size_t i = first; i <= last; ++i) {
    if (!ways.allows(tour[i].group, 3)) return true;
  }
  return false;
}

// Reverses one stretch if that shortens the tour.
bool reverse_a_stretch(const GroupWays& ways, Tour& tour) {
  bool improved = false;
  for (std::size_t i = 0; i < tour.size(); ++i) {
    for (std::size_t j = i; j < tour.size(); ++j) {
      if (!ways.allows(tour[j].group, 3)) break;
      const bool at_end = j + 1 == tour.size();
      const Step first = reversed(ways, tour[j]), last = reversed(ways, tour[i]);
      const double old_m =
          link_m(ways, tour, i, tour[i]) + (at_end ? 0 : way_m(ways, tour[j], tour[j + 1]));
      if (least_link_m(ways, tour, i, first) + (at_end ? 0 : straight_m(ways, last, tour[j + 1])) >=
          old_m - gain_m) {
        continue;
      }
      const double new_m =
          link_m(ways, tour, i, first) + (at_end ? 0 : way_m(ways, last, tour[j + 1]));
      if (new_m >= old_m - gain_m) continue;
      const auto begin = tour.begin() + static_cast<std::ptrdiff_t>(i);
      const auto end = tour.begin() + static_cast<std::ptrdiff_t>(j) + 1;
      std::reverse(begin, end);
      std::for_each(begin, end, [&](Step& s) { s = reversed(ways, s); });
      improved = true;
    }
  }
  return improved;
}

double tour_m(const GroupWays& ways, const Tour& tour) {
  double sum = 0;
  for (std::size_t i = 0; i < tour.size(); ++i) {
    sum += link_m(ways, tour, i, tour[i]) + ways.turns_m(tour[i].group, tour[i].sense);
  }
  return sum;
}

// Where `block` fits best into `rest`, if that is cheaper than `worth_m`.
std::optional<Tour> inserted(const GroupWays& ways, const Tour& rest, const Tour& block,
                             double worth_m) {
  std::size_t best_at = rest.size() + 1;
  double best_m = worth_m - gain_m;
  for (std::size_t at = 0; at <= rest.size(); ++at) {
    const bool at_end = at == rest.size();
    const double gap_m = at_end ? 0 : link_m(ways, rest, at, rest[at]);
    const double least_m = least_link_m(ways, rest, at, block.front()) +
                           (at_end ? 0 : straight_m(ways, block.back(), rest[at])) - gap_m;
    if (least_m >= best_m) continue;
    const double added_m = link_m(ways, rest, at, block.front()) +
                           (at_end ? 0 : way_m(ways, block.back(), rest[at])) - gap_m;
    if (added_m < best_m) {
      best_m = added_m;
      best_at = at;
    }
  }
  if (best_at > rest.size()) return std::nullopt;
  Tour made = rest;
  made.insert(made.begin() + static_cast<std::ptrdiff_t>(best_at), block.begin(), block.end());
  return made;
}

// Moves one stretch of up to `longest_move` groups, either way round, if that shortens the tour.
bool move_a_stretch(const GroupWays& ways, Tour& tour) {
  bool improved = false;
  for (std::size_t i = 0; i < tour.size(); ++i) {
    for (std::size_t count = 1; count <= longest_move && i + count < tour.size(); ++count) {
      const auto begin = tour.begin() + static_cast<std::ptrdiff_t>(i);
      const auto end = begin + static_cast<std::ptrdiff_t>(count);
      const std::size_t after = i + count;
      Tour block(begin, end), rest(tour.begin(), begin);
      rest.insert(rest.end(), end, tour.end());
      const double worth_m = link_m(ways, tour, i, tour[i]) +
                             way_m(ways, tour[after - 1], tour[after]) -
                             link_m(ways, rest, i, rest[i]);
      if (worth_m <= gain_m) continue;
      std::optional<Tour> better = inserted(ways, rest, block, worth_m);
      if (!better && !has_fixed(ways, tour, i, after - 1)) {
        std::reverse(block.begin(), block.end());
        for (Step& s : block) s = reversed(ways, s);
        better = inserted(ways, rest, block, worth_m);
      }
      if (better) {
        tour = std::move(*better);
        improved = true;
      }
    }
  }
  return improved;
}

// The senses that make this order of groups shortest.
void choose_senses(const GroupWays& ways, Tour& tour) {
  const std::size_t n = tour.size();
  std::vector<double> best(n * senses, INFINITY);
  std::vector<std::size_t> before(n * senses, 0);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t g = tour[i].group;
    for (std::size_t s = 0; s < senses; ++s) {
      if (!ways.allows(g, s)) continue;
      const double own_m = ways.turns_m(g, s);
      if (i == 0) best[s] = ways.first_m(g, s) + own_m;
      for (std::size_t p = 0; i > 0 && p < senses; ++p) {
        const double to_m = best[(i - 1) * senses + p];
        if (to_m == INFINITY) continue;
        const double length_m = to_m + ways.way_m(tour[i - 1].group, p, g, s) + own_m;
        if (length_m < best[i * senses + s]) {
          best[i * senses + s] = length_m;
          before[i * senses + s] = p;
        }
      }
    }
  }
  const auto last = best.end() - static_cast<std::ptrdiff_t>(senses);
  auto s = static_cast<std::size_t>(std::min_element(last, best.end()) - last);
  for (std::size_t i = n; i-- > 0;) {
    tour[i].sense = s;
    s = before[i * senses + s];
  }
}

Tour improved_tour(const GroupWays& ways) {
  Tour tour = nearest_tour(ways);
  double length = tour_m(ways, tour);
  for (int round = 0; round < most_rounds; ++round) {
    bool improved = reverse_a_stretch(ways, tour);
    improved = move_a_stretch(ways, tour) || improved;
    choose_senses(ways, tour);
    const double now = tour_m(ways, tour);
    if (!improved || now >= length - gain_m) break;
    length = now;
  }
  return tour;
}

// Prim's algorithm over groups, the straight distance between any two ends as length.
double spanning_tree_m(const GroupWays& ways) {
  const std::size_t n = ways.size();
  std::vector<double> away_m(n, INFINITY);
  std::vector<bool> joined(n, false);
  double sum = 0;
  std::size_t latest = 0;
  for (std::size_t count = 1; count < n; ++count) {
    joined[latest] = true;
    std::size_t next = latest;
    for (std::size_t g = 0; g < n; ++g) {
      if (joined[g]) continue;
      for (std::size_t s = 0; s < senses * senses; ++s) {
        const std::size_t a = s / senses, b = s % senses;
        away_m[g] = std::min({away_m[g], norm(ways.entry(latest, a) - ways.entry(g, b)),
                              norm(ways.exit(latest, a) - ways.entry(g, b)),
                              norm(ways.exit(g, b) - ways.entry(latest, a))});
      }
      if (next == latest || away_m[g] < away_m[next]) next = g;
    }
    sum += away_m[next];
    latest = next;
  }
  return sum;
}

double bound_m(const GroupWays& ways, double strips_m) {
  double sum = strips_m + spanning_tree_m(ways);
  for (std::size_t g = 0; g < ways.size(); ++g) {
    double least_m = INFINITY;
    for (std::size_t s = 0; s < senses; ++s) {
      if (ways.allows(g, s)) least_m = std::min(least_m, ways.turns_m(g, s));
    }
    sum += least_m;
  }
  return sum;
}

}  // namespace

StripOrder strip_order(const std::vector<StripGroup>& groups, const InsidePaths& paths,
                       std::optional<PointM> start) {
  if (groups.empty()) return {};
  const GroupWays ways{groups, paths, start};
  StripOrder made;
  made.exact = groups.size() <= most_exact;
  const Tour tour = made.exact ? exact_tour(ways) : improved_tour(ways);
  double strips_m = 0;
  for (const Step step : tour) {
    for (const GroundStrip& strip : ways.flown(step.group, step.sense)) {
      OrderedStrip next{strip, {}};
      if (!made.strips.empty()) {
        // No way at all leaves the approach empty: the aircraft comes as it does to the first.
        if (auto way = paths.shortest(made.strips.back().strip.b, strip.a)) {
          next.approach = std::move(*way);
        }
      }
      strips_m += norm(strip.b - strip.a);
      made.route_m += norm(strip.b - strip.a) + length_m(next.approach);
      made.strips.push_back(std::move(next));
    }
  }
  made.bound_m = made.exact && !start ? made.route_m : bound_m(ways, strips_m);
  return made;
}

}  // namespace furrow::planner
