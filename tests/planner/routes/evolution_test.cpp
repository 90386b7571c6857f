#include "planner/routes/evolution.hpp"

#include "planner/routes/asymmetric_crossover.hpp"
#include "planner/routes/binary_crossover.hpp"
#include "planner/routes/heuristic_mutation.hpp"
#include "planner/routes/mixed_selection.hpp"
#include "tests/planner/routes/hills.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

namespace furrow::planner {
namespace {

// A box of ten parts of 10 m on each axis; a gene is named by its x.
Scene boxed() {
  return {.surface = Surface::level(metres(0)),
          .low = {0, 0, 0},
          .high = {100, 100, 100},
          .clearance_m = 5,
          .start = {1, 1, 10},
          .goal = {99, 99, 10}};
}
Genes genes(std::initializer_list<double> xs) {
  Genes g;
  for (const double x : xs) g.push_back({x, 50, 50});
  return g;
}
std::vector<double> xs(const Genes& genes) {
  std::vector<double> x;
  for (const WayPoint& p : genes) x.push_back(p.x_m);
  return x;
}
using Xs = std::vector<double>;

TEST_CASE("Early children keep their head, and map duplicates behind it") {
  const Partition partition{boxed(), 10};
  // Head 15 25 of a, tail 27 55 of b. 27 lies in the cell of 25. It was exchanged for a's 35.
  const Genes a = genes({15, 25, 35, 45}), b = genes({65, 27, 55});
  CHECK(xs(spliced(a, 2, b, 1, partition, DuplicateRule::mapping)) == Xs{15, 25, 35, 55});
  // Where the chain ends without a new gene, the duplicate is removed: 17 <-> 15's own cell.
  const Genes c = genes({15, 25}), d = genes({65, 75, 17});
  CHECK(xs(spliced(c, 2, d, 2, partition, DuplicateRule::mapping)) == Xs{15, 25});
  // A chain of two: 16 <-> 26, taken by the head; 26's cell in the tail <-> 85.
  const Genes e = genes({15, 25, 26, 85}), f = genes({16, 27});
  CHECK(xs(spliced(e, 2, f, 0, partition, DuplicateRule::mapping)) == Xs{15, 25, 85});
}

TEST_CASE("Late children keep their tail, and fill before it with the other's missing genes") {
  const Partition partition{boxed(), 10};
  // Tail 27 55 of b; before it the first two of a that are not in it: 15, then 35 for 25.
  const Genes a = genes({15, 25, 35, 45}), b = genes({65, 27, 55});
  CHECK(xs(spliced(a, 2, b, 1, partition, DuplicateRule::order)) == Xs{15, 35, 27, 55});
}

TEST_CASE("Children have no gene twice, at least one, and any length") {
  const Scene scene = boxed();
  const Partition partition{scene, 6};
  Random random{3};
  std::set<std::size_t> lengths;
  for (int i = 0; i < 2000; ++i) {
    Genes a(1 + random.below(8)), b(1 + random.below(8));
    for (WayPoint& p : a) p = {random.uniform(0, 100), 50, 50};
    for (WayPoint& p : b) p = {random.uniform(0, 100), 50, 50};
    const auto rule = i % 2 ? DuplicateRule::mapping : DuplicateRule::order;
    const auto [c, d] = asymmetric_crossover(a, b, partition, rule, 10, random);
    for (const Genes& child : {c, d}) {
      std::set<std::uint64_t> cells;
      for (const WayPoint& p : child) cells.insert(partition.cell(p));
      REQUIRE(cells.size() == child.size());
      REQUIRE((!child.empty() && child.size() <= 10));
      lengths.insert(child.size());
    }
  }
  CHECK(lengths.size() == 6);  // 1 to 6, as there are six cells
}

TEST_CASE("Mixed selection picks no route twice and prefers the cheap") {
  Population population;
  for (int i = 0; i < 20; ++i) {
    population.push_back(
        {genes({5.0 * (i / 2)}), {.length_m = 100.0 * (1 + i)}});  // pairs of twins
  }
  std::vector<int> picked(10, 0);
  Random random{5};
  for (int run = 0; run < 2000; ++run) {
    const auto picks = mixed_selection(population, 0.5, random);
    std::set<double> distinct;
    for (const std::size_t i : picks) {
      distinct.insert(population[i].genes.front().x_m);
      ++picked[i / 2];
    }
    REQUIRE(distinct.size() == picks.size());
    REQUIRE(picks.size() <= 10);
  }
  CHECK(std::is_sorted(picked.rbegin(), picked.rend()));
  CHECK(picked.front() > 2 * picked.back());
}

TEST_CASE("Roulette slots are as wide as one over the cost") {
  // Costs 1 and 3: slots 1 and 1/3, so 3/4 of the picks are the first. 20 000 picks: sd 61.
  const Population population{{genes({1}), {.length_m = 1}}, {genes({2}), {.length_m = 3}}};
  Random random{6};
  int first = 0;
  for (int i = 0; i < 10'000; ++i) {
    for (const std::size_t pick : roulette_selection(population, random)) first += pick == 0;
  }
  CHECK(std::abs(first - 15'000) < 250);
}

TEST_CASE("Simulated binary crossover keeps the middle of the parents and the box") {
  const Scene scene = boxed();
  const Genes a = genes({40, 10}), b = genes({60, 90, 70});
  Random random{8};
  for (int i = 0; i < 500; ++i) {
    const auto [c, d] = binary_crossover(a, b, scene, 15, random);
    REQUIRE((c.size() == 2 && d.size() == 3));
    CHECK(c[0].x_m + d[0].x_m == Approx(100));
    CHECK(d[2].x_m == 70);  // without a partner
    for (const WayPoint& p : c) CHECK((p.x_m >= 0 && p.x_m <= 100));
  }
}

TEST_CASE("Heuristic mutation lifts a way point out of the ground before all else") {
  // The only inner way point lies under ground: one round moves it until it is clear.
  const Scene scene = boxed();
  Genes buried = genes({50, 52});
  buried[0].z_m = buried[1].z_m = 1;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    RouteJudge judge{scene};
    Random random{seed};
    const Individual after = heuristic_mutation({buried[0]}, 1, judge, random);
    REQUIRE(after.genes.size() == 1);  // the last is never deleted
    CHECK(is_clear(scene, after.genes[0]));
  }
}

TEST_CASE("Heuristic mutation deletes what makes a detour") {
  // Five way points on the straight line and one far off: the straight remains are far cheaper.
  const Scene scene = boxed();
  RouteJudge judge{scene};
  Random random{2};
  Individual one{{{20, 20, 10}, {40, 40, 10}, {90, 5, 90}, {80, 80, 10}}, {}};
  one.cost = judge.cost(one.genes);
  const double before = one.cost.total();
  for (int i = 0; i < 60; ++i) {
    Individual next = heuristic_mutation(one.genes, 4, judge, random);
    if (next.cost.total() < one.cost.total()) one = next;
  }
  CHECK(before > 1.5 * distance_m(scene.start, scene.goal));
  CHECK(one.cost.total() < 1.02 * distance_m(scene.start, scene.goal));
}

TEST_CASE("The improved algorithm beats the plain one on the same budget, and repeats itself") {
  const Scene scene = hills::scene(2);
  double improved = 0, plain = 0;
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const RouteSearch a = evolved_route(scene, {}, 4000, seed);
    const RouteSearch b = evolved_route(scene, plain_evolution(), 4000, seed);
    improved += a.best.cost.total();
    plain += b.best.cost.total();
    CHECK(a.best.cost.is_feasible());
    CHECK(std::is_sorted(a.history.rbegin(), a.history.rend()));
    CHECK(a.evaluations < 4000 + 40 * 8);
  }
  CHECK(improved < plain);
  const RouteSearch once = evolved_route(scene, {}, 2000, 1);
  CHECK(once.best.genes == evolved_route(scene, {}, 2000, 1).best.genes);
  CHECK(once.history != evolved_route(scene, {}, 2000, 2).history);
}

}  // namespace
}  // namespace furrow::planner
