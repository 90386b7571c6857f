#include "app/results/report/shares.hpp"

#include "app/results/report/palette.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <set>
#include <utility>

namespace furrow::app {
namespace {

using Square = std::pair<int, int>;

// A lattice wide enough that strips side by side lie in the same or in adjacent squares.
Square square_of(FieldPoint p, double side_m) {
  return {static_cast<int>(std::floor(p.x.base() / side_m)),
          static_cast<int>(std::floor(p.y.base() / side_m))};
}

// On a survey, aircraft are neighbours where they visit the same hectare.
double lattice_side_m(const planner::Route& route) {
  return planner::is_survey(route) ? 100 : 1.5 * route.cell.base();
}

template <class Visit>
void around(Square s, Visit visit) {
  for (int dx = -1; dx <= 1; ++dx) {
    for (int dy = -1; dy <= 1; ++dy) visit(Square{s.first + dx, s.second + dy});
  }
}

std::vector<std::set<std::size_t>> neighbours(const planner::Route& route,
                                              const std::vector<scheduler::UavPlan>& uavs) {
  const double side_m = lattice_side_m(route);
  std::map<Square, std::set<std::size_t>> holders;
  for (std::size_t u = 0; u < uavs.size(); ++u) {
    for (std::uint32_t i = uavs[u].cells.first; i < end(uavs[u].cells); ++i) {
      holders[square_of(route.centers[i], side_m)].insert(u);
    }
  }
  std::vector<std::set<std::size_t>> touching(uavs.size());
  for (const auto& [square, here] : holders) {
    around(square, [&](Square beside) {
      const auto there = holders.find(beside);
      if (there == holders.end()) return;
      for (const std::size_t u : here)
        touching[u].insert(there->second.begin(), there->second.end());
    });
  }
  for (std::size_t u = 0; u < uavs.size(); ++u) touching[u].erase(u);
  return touching;
}

// The first shade is the hue itself, the second is lighter and the third darker.
std::string shaded(std::string_view hue, std::size_t shade) {
  if (shade % 3 == 0) return std::string{hue};
  std::string colour = "#";
  for (const std::size_t at : {1u, 3u, 5u}) {
    int part = 0;
    std::from_chars(hue.data() + at, hue.data() + at + 2, part, 16);
    part = shade % 3 == 1 ? part + (255 - part) / 2 : part * 6 / 10;
    colour += fmt::format("{:02x}", part);
  }
  return colour;
}

// Cells of one UAV that hang together, largest first.
std::vector<std::vector<std::uint32_t>> pieces(const planner::Route& route, CellRange cells) {
  const double side_m = lattice_side_m(route);
  std::map<Square, std::vector<std::uint32_t>> left;
  for (std::uint32_t i = cells.first; i < end(cells); ++i) {
    left[square_of(route.centers[i], side_m)].push_back(i);
  }
  std::vector<std::vector<std::uint32_t>> all;
  while (!left.empty()) {
    std::vector<std::uint32_t> piece;
    std::vector<Square> open{left.begin()->first};
    while (!open.empty()) {
      const Square square = open.back();
      open.pop_back();
      const auto held = left.find(square);
      if (held == left.end()) continue;
      piece.insert(piece.end(), held->second.begin(), held->second.end());
      left.erase(held);
      around(square, [&](Square beside) { open.push_back(beside); });
    }
    all.push_back(std::move(piece));
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return all;
}

// The cell nearest to the centroid: on the piece, even where the centroid is not.
FieldPoint middle(const planner::Route& route, const std::vector<std::uint32_t>& piece) {
  double x_m = 0, y_m = 0;
  for (const std::uint32_t i : piece) {
    x_m += route.centers[i].x.base();
    y_m += route.centers[i].y.base();
  }
  const double count = static_cast<double>(piece.size());
  const FieldPoint centroid = at_m(x_m / count, y_m / count);
  return route
      .centers[*std::min_element(piece.begin(), piece.end(), [&](std::uint32_t a, std::uint32_t b) {
        return distance(route.centers[a], centroid) < distance(route.centers[b], centroid);
      })];
}

}  // namespace

Colours uav_colours(const planner::Route& route, const std::vector<scheduler::UavPlan>& uavs) {
  const auto touching = neighbours(route, uavs);
  std::vector<std::size_t> hue_of(uavs.size());
  std::array<std::size_t, hues.size()> uses{};
  Colours colours;
  for (std::size_t u = 0; u < uavs.size(); ++u) {
    std::array<bool, hues.size()> is_taken{};
    for (const std::size_t beside : touching[u]) {
      if (beside < u) is_taken[hue_of[beside]] = true;
    }
    std::size_t best = 0;
    for (std::size_t h = 1; h < hues.size(); ++h) {
      if (std::pair{is_taken[h], uses[h]} < std::pair{is_taken[best], uses[best]}) best = h;
    }
    hue_of[u] = best;
    colours.push_back(shaded(hues[best], uses[best]++));
  }
  return colours;
}

std::vector<std::vector<FieldPoint>> label_places(const planner::Route& route,
                                                  const std::vector<scheduler::UavPlan>& uavs) {
  std::vector<std::vector<FieldPoint>> places(uavs.size());
  for (std::size_t u = 0; u < uavs.size(); ++u) {
    for (const auto& piece : pieces(route, uavs[u].cells)) {
      if (!places[u].empty() && piece.size() * 4 < uavs[u].cells.count) break;
      places[u].push_back(middle(route, piece));
    }
  }
  return places;
}

}  // namespace furrow::app
