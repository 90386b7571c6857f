#include "scheduler/lower_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

namespace furrow::scheduler {
namespace {

constexpr double tolerance_s = 0.05;
constexpr std::size_t most_sets = 4096;

/// The largest time, within the tolerance, that `is_too_short` holds for; it holds below some time
/// and not above.
template <class Question>
double last_short_s(Question is_too_short) {
  double low_s = 0.0, high_s = 1.0;
  for (; is_too_short(high_s); high_s *= 2.0) low_s = high_s;
  while (high_s - low_s > tolerance_s) {
    const double middle_s = 0.5 * (low_s + high_s);
    (is_too_short(middle_s) ? low_s : high_s) = middle_s;
  }
  return low_s;
}

using Group = std::vector<Vehicle>;

auto likeness(const Vehicle& v) {
  return std::tuple{v.spray_speed.base(), v.ferry_speed.base(), tank_range(v).base()};
}

/// How many sets of aircraft there are when those of a group are counted, not told apart.
std::size_t sets(const std::vector<Group>& groups) {
  std::size_t product = 1;
  for (const Group& g : groups) product = std::min(product * (g.size() + 1), 2 * most_sets);
  return product;
}

/// Merges the two neighbours whose spray speeds are nearest.
void merge_once(std::vector<Group>& groups) {
  const auto step = [](const Group& slow, const Group& fast) {
    return fast.front().spray_speed / slow.back().spray_speed;
  };
  std::size_t nearest = 0;
  for (std::size_t g = 1; g + 1 < groups.size(); ++g) {
    if (step(groups[g], groups[g + 1]) < step(groups[nearest], groups[nearest + 1])) nearest = g;
  }
  Group& kept = groups[nearest];
  Group& gone = groups[nearest + 1];
  kept.insert(kept.end(), gone.begin(), gone.end());
  groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(nearest) + 1);
}

std::vector<Group> groups_of(std::span<const Vehicle> vehicles) {
  Group sorted{vehicles.begin(), vehicles.end()};
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Vehicle& a, const Vehicle& b) { return likeness(a) < likeness(b); });
  std::vector<Group> groups;
  for (const Vehicle& v : sorted) {
    if (groups.empty() || likeness(groups.back().back()) != likeness(v)) groups.emplace_back();
    groups.back().push_back(v);
  }
  while (sets(groups) > most_sets) merge_once(groups);
  return groups;
}

/// How far along the route sets of aircraft get by a time.
class Reach {
 public:
  Reach(const planner::Route& route, const RouteLengths& lengths, std::span<const Vehicle> vehicles,
        std::span<const Station> stations)
      : route_{route}, lengths_{lengths} {
    for (const Group& g : groups_of(vehicles)) {
      kinds_.push_back({fastest_pace(route, g, stations, lengths.nearest_m), g.size()});
    }
  }

  bool leaves_strips(double finish_s) const {
    std::vector<std::vector<std::uint32_t>> ends(kinds_.size());
    for (auto& of_kind : ends) of_kind.assign(route_.strips.size() + 1, unknown);
    // Sets are numbered by their counts as digits, the first kind's running fastest.
    std::vector<std::uint32_t> reached{0};
    std::size_t below = 1;  // sets of the kinds so far
    for (std::size_t k = 0; k < kinds_.size(); ++k) {
      for (std::size_t set = below; set < below * (kinds_[k].count + 1); ++set) {
        std::uint32_t furthest = 0;
        std::size_t unit = 1;
        for (std::size_t j = 0; j <= k; ++j) {
          if (set / unit % (kinds_[j].count + 1) > 0) {
            furthest = std::max(furthest, end_of(j, reached[set - unit], finish_s, ends[j]));
          }
          unit *= kinds_[j].count + 1;
        }
        reached.push_back(furthest);
      }
      below *= kinds_[k].count + 1;
    }
    return reached.back() < route_.strips.size();
  }

 private:
  struct Kind {
    Pace pace;
    std::size_t count;
  };
  static constexpr std::uint32_t unknown = std::numeric_limits<std::uint32_t>::max();

  /// The strip after the last that one aircraft, starting at `first`, has done by `finish_s`.
  std::uint32_t end_of(std::size_t kind, std::uint32_t first, double finish_s,
                       std::vector<std::uint32_t>& ends) const {
    std::uint32_t& next = ends[first];
    if (next != unknown) return next;
    next = first;
    GrowingShare growing{route_, lengths_, kinds_[kind].pace, first};
    while (growing.can_grow() && growing.grow() <= finish_s) ++next;
    return next;
  }

  const planner::Route& route_;
  const RouteLengths& lengths_;
  std::vector<Kind> kinds_{};
};

/// What all bays together need to fill in, shared among them.
double filling_s(const planner::Route& route, const RouteLengths& lengths,
                 std::span<const Vehicle> vehicles, std::span<const Station> stations) {
  const Pace best = fastest_pace(route, vehicles, stations, lengths.nearest_m);
  // One move between cells is not sprayed at each cut.
  const double cuts = static_cast<double>(std::min(vehicles.size(), route.strips.size())) - 1.0;
  double filled_m = lengths.spray_m.back() - cuts * route.cell.base();
  for (const Vehicle& v : vehicles) filled_m -= tank_range(v).base();
  if (filled_m <= 0.0) return 0.0;
  double bays = 0.0;
  for (const Station& s : stations) bays += s.bays;
  return (std::ceil(filled_m / best.tank_m) * best.fill_base_s + filled_m * best.fill_s_per_m) /
         bays;
}

}  // namespace

double makespan_bound_s(const planner::Route& route, const RouteLengths& lengths,
                        std::span<const Vehicle> vehicles, std::span<const Station> stations) {
  const Reach reach{route, lengths, vehicles, stations};
  const double by_share_s =
      last_short_s([&](double finish_s) { return reach.leaves_strips(finish_s); });
  return std::max(by_share_s, filling_s(route, lengths, vehicles, stations));
}

}  // namespace furrow::scheduler
