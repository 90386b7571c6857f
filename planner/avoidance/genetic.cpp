#include "planner/avoidance/genetic.hpp"

#include "core/random.hpp"
#include "core/require.hpp"

#include <algorithm>

namespace furrow::planner {
namespace {

struct Member {
  Selection genes;
  double fitness;
};

constexpr std::ptrdiff_t elders = 2;  // live on unchanged
constexpr int tournament = 3;

std::uint16_t drawn_option(const SelectionProblem& p, std::size_t crowd, Random& random) {
  return static_cast<std::uint16_t>(random.below(p.crowds[crowd].size()));
}

const Member& parent(const std::vector<Member>& population, Random& random) {
  const Member* best = nullptr;
  for (int i = 0; i < tournament; ++i) {
    const Member& drawn = population[random.below(population.size())];
    if (!best || drawn.fitness < best->fitness) best = &drawn;
  }
  return *best;
}

Selection child(const SelectionProblem& p, const Member& a, const Member& b, Random& random) {
  Selection genes(p.crowds.size());
  const double mutation = 1.0 / static_cast<double>(genes.size());
  for (std::size_t i = 0; i < genes.size(); ++i) {
    genes[i] = random.uniform() < 0.5 ? a.genes[i] : b.genes[i];
    if (random.uniform() < mutation) genes[i] = drawn_option(p, i, random);
  }
  return genes;
}

void sort_by_fitness(std::vector<Member>& population) {
  std::stable_sort(population.begin(), population.end(),
                   [](const Member& a, const Member& b) { return a.fitness < b.fitness; });
}

}  // namespace

GeneticResult genetic_selection(const SelectionProblem& p, const GeneticSettings& s,
                                const std::vector<Selection>& starts) {
  require(s.population >= 2, "a population has two members");
  if (p.crowds.empty()) return {{}, fitness(p, {}), 0};
  Random random{seed_for(s.seed, {0x64e7})};
  std::vector<Member> population;
  while (population.size() < s.population) {
    Selection genes;
    if (population.size() < starts.size()) {
      genes = starts[population.size()];
    } else {
      for (std::size_t i = 0; i < p.crowds.size(); ++i) {
        genes.push_back(drawn_option(p, i, random));
      }
    }
    const double value = fitness(p, genes);
    population.push_back({std::move(genes), value});
  }
  sort_by_fitness(population);

  std::uint32_t made = 0;
  while (made < s.iterations && population.front().fitness > s.target_fitness) {
    std::vector<Member> next(population.begin(), population.begin() + elders);
    while (next.size() < population.size()) {
      const Member& a = parent(population, random);
      const Member& b = parent(population, random);
      Selection genes = child(p, a, b, random);
      const double value = fitness(p, genes);
      next.push_back({std::move(genes), value});
    }
    population = std::move(next);
    sort_by_fitness(population);
    ++made;
  }
  return {population.front().genes, population.front().fitness, made};
}

}  // namespace furrow::planner
