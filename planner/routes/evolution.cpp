#include "planner/routes/evolution.hpp"

#include "core/require.hpp"
#include "planner/routes/asymmetric_crossover.hpp"
#include "planner/routes/binary_crossover.hpp"
#include "planner/routes/heuristic_mutation.hpp"
#include "planner/routes/mixed_selection.hpp"

#include <algorithm>

namespace furrow::planner {
namespace {

class Generations {
 public:
  Generations(const Scene& scene, const EvolutionSettings& settings, std::uint64_t evaluations,
              std::uint64_t seed)
      : settings_{settings},
        budget_{static_cast<double>(evaluations)},
        partition_{scene, settings.intervals},
        judge_{scene},
        random_{seed} {
    for (std::uint32_t i = 0; i < settings.population; ++i) population_.push_back(newcomer());
    remember_best();
  }

  RouteSearch run() && {
    while (judge_.evaluations() < budget_) {
      population_ = next();
      remember_best();
    }
    return {std::move(best_), std::move(history_), judge_.evaluations()};
  }

 private:
  Individual newcomer() {
    Genes genes;
    for (std::uint32_t i = 2; i < settings_.chromosome; ++i) {
      genes.push_back(scattered(judge_.scene(), random_));
    }
    const RouteCost cost = judge_.cost(genes);
    return {std::move(genes), cost};
  }

  Population next() {
    const auto picks = settings_.selection == ParentSelection::mixed
                           ? mixed_selection(population_, settings_.tournament_share, random_)
                           : roulette_selection(population_, random_);
    Population children{best_};
    while (children.size() < population_.size()) {
      const Individual& a = population_[picks[random_.below(picks.size())]];
      const Individual& b = population_[picks[random_.below(picks.size())]];
      add_children(a, b, children);
    }
    return children;
  }

  void add_children(const Individual& a, const Individual& b, Population& children) {
    const bool crossed = random_.uniform() < settings_.crossover_rate && !(a.genes == b.genes);
    if (!crossed) {
      children.push_back(mutated(a));
      if (children.size() < population_.size()) children.push_back(mutated(b));
      return;
    }
    auto [first, second] = cross(a.genes, b.genes);
    children.push_back(mutated(std::move(first)));
    if (children.size() < population_.size()) children.push_back(mutated(std::move(second)));
  }

  std::pair<Genes, Genes> cross(const Genes& a, const Genes& b) {
    if (settings_.crossover == Crossover::simulated_binary) {
      return binary_crossover(a, b, judge_.scene(), settings_.eta, random_);
    }
    const bool early = judge_.evaluations() <= settings_.mapping_share * budget_;
    return asymmetric_crossover(a, b, partition_,
                                early ? DuplicateRule::mapping : DuplicateRule::order,
                                most_way_points - 2, random_);
  }

  Individual mutated(const Individual& one) { return mutates() ? mutation(one.genes) : one; }
  Individual mutated(Genes genes) {
    if (mutates()) return mutation(genes);
    const RouteCost cost = judge_.cost(genes);
    return {std::move(genes), cost};
  }
  bool mutates() { return random_.uniform() < settings_.mutation_rate; }
  Individual mutation(const Genes& genes) {
    return settings_.mutation == Mutation::random
               ? random_mutation(genes, judge_, random_)
               : heuristic_mutation(genes, settings_.mutation_rounds, judge_, random_);
  }

  void remember_best() {
    const auto best = std::min_element(
        population_.begin(), population_.end(),
        [](const auto& a, const auto& b) { return a.cost.total() < b.cost.total(); });
    if (history_.empty() || best->cost.total() < best_.cost.total()) best_ = *best;
    history_.push_back(best_.cost.total());
  }

  EvolutionSettings settings_;
  double budget_;
  Partition partition_;
  RouteJudge judge_;
  Random random_;
  Population population_;
  Individual best_;
  std::vector<double> history_;
};

}  // namespace

RouteSearch evolved_route(const Scene& scene, const EvolutionSettings& settings,
                          std::uint64_t evaluations, std::uint64_t seed) {
  require(settings.population >= 2 && settings.chromosome >= 3 && settings.chromosome <= 32 &&
              evaluations >= settings.population,
          "a population of two or more, with way points, is judged once at least");
  return Generations{scene, settings, evaluations, seed}.run();
}

EvolutionSettings plain_evolution(EvolutionSettings settings) {
  settings.selection = ParentSelection::roulette;
  settings.crossover = Crossover::simulated_binary;
  settings.mutation = Mutation::random;
  return settings;
}

}  // namespace furrow::planner
