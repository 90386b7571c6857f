#include "planner/coverage/swath/group_ways.hpp"

#include <algorithm>

namespace furrow::planner {
namespace {

constexpr std::size_t most_remembered = 300;  // groups whose pairs of ways are kept

double inside_m(const InsidePaths& paths, PointM a, PointM b) {
  const auto path = paths.shortest(a, b);
  // Both ends lie on one connected piece, so a way exists; rounding at a pinched corner may hide
  // it, and then the detour is priced high, not forbidden.
  return path ? length_m(*path) : 1e3 * norm(b - a);
}

// turns[k][side]: from strip k to k + 1 at end a (0) or b (1).
std::vector<std::array<double, 2>> turns_of(const StripGroup& group, const InsidePaths& paths) {
  std::vector<std::array<double, 2>> turns;
  for (std::size_t k = 0; k + 1 < group.strips.size(); ++k) {
    const GroundStrip& here = group.strips[k];
    const GroundStrip& next = group.strips[k + 1];
    if (group.flown != Flown::to_and_fro) {
      const double way = inside_m(paths, here.b, next.a);
      turns.push_back({way, way});
    } else {
      turns.push_back({inside_m(paths, here.a, next.a), inside_m(paths, here.b, next.b)});
    }
  }
  return turns;
}

}  // namespace

GroupWays::GroupWays(const std::vector<StripGroup>& groups, const InsidePaths& paths,
                     std::optional<PointM> start)
    : groups_{groups}, paths_{paths}, start_{start} {
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const auto turns = turns_of(groups[g], paths);
    std::array<Ends, senses> ends{};
    for (std::size_t s = 0; s < senses; ++s) {
      const std::vector<GroundStrip> order = flown(g, s);
      ends[s] = {order.front().a, order.back().b, 0};
      bool at_b = !sense(s).from_b;  // where the first strip flown ends
      for (std::size_t k = 0; k < turns.size(); ++k, at_b = !at_b) {
        ends[s].turns_m += turns[sense(s).from_last ? turns.size() - 1 - k : k][at_b ? 1 : 0];
      }
    }
    ends_.push_back(ends);
  }
  if (groups.size() <= most_remembered) known_m_.assign(16 * groups.size() * groups.size(), -1);
}

std::vector<GroundStrip> GroupWays::flown(std::size_t group, std::size_t number) const {
  std::vector<GroundStrip> order = groups_[group].strips;
  if (sense(number).from_last) std::reverse(order.begin(), order.end());
  bool from_b = sense(number).from_b;
  for (GroundStrip& strip : order) {
    if (from_b) std::swap(strip.a, strip.b);
    if (groups_[group].flown == Flown::to_and_fro) from_b = !from_b;
  }
  return order;
}

std::size_t GroupWays::exit_corner(std::size_t group, std::size_t number) const {
  const Sense s = sense(number);
  const bool turns = groups_[group].flown == Flown::to_and_fro;
  const bool at_b = (!turns || groups_[group].strips.size() % 2 == 1) != s.from_b;
  return (s.from_last ? 0u : 2u) + (at_b ? 1u : 0u);
}

std::size_t GroupWays::reversed(std::size_t group, std::size_t sense) const {
  return groups_[group].flown == Flown::as_it_is ? sense : exit_corner(group, sense);
}

double GroupWays::way_m(std::size_t from, std::size_t from_sense, std::size_t to,
                        std::size_t to_sense) const {
  const PointM a = exit(from, from_sense), b = entry(to, to_sense);
  if (known_m_.empty()) return inside_m(paths_, a, b);
  // Two senses that leave at one corner share its ways.
  const std::size_t corner = exit_corner(from, from_sense);
  double& known = known_m_[(4 * from + corner) * 4 * size() + 4 * to + to_sense];
  if (known < 0) known = inside_m(paths_, a, b);
  return known;
}

double GroupWays::first_m(std::size_t group, std::size_t sense) const {
  return start_ ? norm(entry(group, sense) - *start_) : 0;
}

}  // namespace furrow::planner
