#include "planner/routes/mixed_selection.hpp"

#include "core/require.hpp"

#include <algorithm>

namespace furrow::planner {
namespace {

class Roulette {
 public:
  explicit Roulette(const Population& population) {
    double sum = 0;
    for (const Individual& one : population) ends_.push_back(sum += 1 / one.cost.total());
  }
  std::size_t pick(Random& random) const {
    const double at = random.uniform(0, ends_.back());
    const auto slot = std::upper_bound(ends_.begin(), ends_.end() - 1, at);
    return static_cast<std::size_t>(slot - ends_.begin());
  }

 private:
  std::vector<double> ends_;
};

std::size_t tournament(const Population& population, Random& random) {
  const std::size_t a = random.below(population.size()), b = random.below(population.size());
  return population[b].cost.total() < population[a].cost.total() ? b : a;
}

}  // namespace

std::vector<std::size_t> mixed_selection(const Population& population, double alpha,
                                         Random& random) {
  require(!population.empty(), "selection is from somebody");
  const Roulette roulette{population};
  const auto by_tournament =
      static_cast<std::size_t>(alpha * static_cast<double>(population.size()));
  std::vector<std::size_t> picks;
  for (std::size_t i = 0; i < population.size(); ++i) {
    const std::size_t pick =
        i < by_tournament ? tournament(population, random) : roulette.pick(random);
    const bool is_in = std::any_of(picks.begin(), picks.end(), [&](std::size_t other) {
      return population[other].genes == population[pick].genes;
    });
    if (!is_in) picks.push_back(pick);
  }
  return picks;
}

std::vector<std::size_t> roulette_selection(const Population& population, Random& random) {
  require(!population.empty(), "selection is from somebody");
  const Roulette roulette{population};
  std::vector<std::size_t> picks;
  for (std::size_t i = 0; i < population.size(); ++i) picks.push_back(roulette.pick(random));
  return picks;
}

}  // namespace furrow::planner
