#include "planner/survey/tour.hpp"

#include "core/random.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

namespace furrow::planner {
namespace {

struct Place {
  double x, y;
};

double length(const std::vector<Place>& places, std::uint32_t a, std::uint32_t b) {
  return std::hypot(places[a].x - places[b].x, places[a].y - places[b].y);
}

double length(const std::vector<Place>& places, const std::vector<std::uint32_t>& order) {
  double sum = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    sum += length(places, order[i], order[(i + 1) % order.size()]);
  }
  return sum;
}

std::vector<std::uint32_t> tour_of(const std::vector<Place>& places) {
  return tour(static_cast<std::uint32_t>(places.size()),
              [&](std::uint32_t a, std::uint32_t b) { return length(places, a, b); });
}

TEST_CASE("A tour of one place stays there") { CHECK(tour_of({{1, 2}}) == std::vector{0u}); }

TEST_CASE("A tour of places on a circle goes round it") {
  std::vector<Place> places;
  for (int i = 0; i < 30; ++i) {
    const double angle = 7 * i * 2 * 3.14159265358979 / 30;  // 7 and 30 have no common factor
    places.push_back({std::cos(angle), std::sin(angle)});
  }
  // 30 chords of 2 sin(6 degrees).
  CHECK(length(places, tour_of(places)) == Approx(60 * std::sin(3.14159265358979 / 30)));
}

TEST_CASE("Tours of eight random places are at most a tenth longer than the shortest") {
  Random random{5};
  double sum = 0, least_sum = 0;
  for (int round = 0; round < 30; ++round) {
    std::vector<Place> places;
    for (int i = 0; i < 8; ++i) places.push_back({random.uniform(0, 100), random.uniform(0, 100)});
    const auto found = tour_of(places);
    CHECK(found.front() == 0);
    CHECK(std::is_permutation(found.begin(), found.end(),
                              std::vector{0u, 1u, 2u, 3u, 4u, 5u, 6u, 7u}.begin()));
    std::vector<std::uint32_t> order(8);
    std::iota(order.begin(), order.end(), 0u);
    double least = length(places, order);
    while (std::next_permutation(order.begin() + 1, order.end())) {
      least = std::min(least, length(places, order));
    }
    CHECK(length(places, found) < 1.1 * least);
    sum += length(places, found);
    least_sum += least;
  }
  CHECK(sum < 1.02 * least_sum);
}

}  // namespace
}  // namespace furrow::planner
