#include "planner/routes/heuristic_mutation.hpp"

#include "core/require.hpp"

#include <algorithm>
#include <limits>

namespace furrow::planner {
namespace {

constexpr std::size_t window = 3;
constexpr int most_tries = 20;

class Mutation {
 public:
  Mutation(const Genes& genes, RouteJudge& judge, Random& random)
      : genes_{genes}, remembered_(genes.size(), false), judge_{judge}, random_{random} {
    best_.cost.length_m = std::numeric_limits<double>::infinity();
  }

  void round() {
    if (!mend_window()) move_one();
    keep_if_best();
    if (genes_.size() < 2) return;
    delete_one();
    keep_if_best();
  }

  Individual take() { return std::move(best_); }

 private:
  // Whether there was something to mend.
  bool mend_window() {
    const std::size_t first = random_.below(genes_.size());
    bool found = false;
    for (std::size_t i = first; i < std::min(first + window, genes_.size()); ++i) {
      if (judge_.is_clear(genes_[i])) continue;
      found = true;
      const WayPoint from = genes_[i];
      for (int t = 0; t < most_tries; ++t) {
        genes_[i] = moved(judge_.scene(), from, random_);
        if (judge_.is_clear(genes_[i])) break;
      }
    }
    return found;
  }

  void move_one() {
    const std::size_t i = random_.below(genes_.size());
    genes_[i] = moved(judge_.scene(), genes_[i], random_);
    remembered_[i] = true;
  }

  void delete_one() {
    std::vector<std::size_t> of;
    for (std::size_t i = 0; i < genes_.size(); ++i) {
      if (remembered_[i]) of.push_back(i);
    }
    const std::size_t i = of.empty() ? random_.below(genes_.size()) : of[random_.below(of.size())];
    genes_.erase(genes_.begin() + static_cast<std::ptrdiff_t>(i));
    remembered_.erase(remembered_.begin() + static_cast<std::ptrdiff_t>(i));
  }

  void keep_if_best() {
    const RouteCost cost = judge_.cost(genes_);
    if (cost.total() < best_.cost.total()) best_ = {genes_, cost};
  }

  Genes genes_;
  std::vector<bool> remembered_;  // R
  RouteJudge& judge_;
  Random& random_;
  Individual best_;
};

}  // namespace

Individual heuristic_mutation(const Genes& genes, std::uint32_t rounds, RouteJudge& judge,
                              Random& random) {
  require(!genes.empty() && rounds >= 1, "a mutation has genes and a round");
  Mutation mutation{genes, judge, random};
  for (std::uint32_t i = 0; i < rounds; ++i) mutation.round();
  return mutation.take();
}

Individual random_mutation(const Genes& genes, RouteJudge& judge, Random& random) {
  Genes changed = genes;
  WayPoint& p = changed[random.below(changed.size())];
  p = moved(judge.scene(), p, random);
  const RouteCost cost = judge.cost(changed);
  return {std::move(changed), cost};
}

}  // namespace furrow::planner
