#include "planner/avoidance/selection.hpp"

#include "core/require.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace furrow::planner {
namespace {

// Cost in fitness of a metre and of a square metre.
struct Price {
  double per_m, per_m2;
};
Price price_of(const SelectionProblem& p) {
  return {p.length_weight / p.straight_m, p.area_weight / p.planned_m2};
}

double own_cost(const SelectionProblem& p, Price price, std::size_t crowd, std::size_t option) {
  const OptionCost& cost = p.crowds[crowd][option];
  return price.per_m * cost.extra_m + price.per_m2 * cost.wrong_m2;
}

double shared_cost(const SelectionProblem& p, Price price, const Interplay& i, std::size_t first,
                   std::size_t second) {
  return price.per_m2 * i.wrong_m2[first * p.crowds[i.second].size() + second];
}

// Crowds joined by interplay, each group in the order flown.
std::vector<std::vector<std::size_t>> groups_of(const SelectionProblem& p) {
  std::vector<std::size_t> root(p.crowds.size());
  std::iota(root.begin(), root.end(), std::size_t{0});
  const auto find = [&](std::size_t i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  for (const Interplay& i : p.interplays) {
    const std::size_t a = find(i.first), b = find(i.second);
    root[std::max(a, b)] = std::min(a, b);
  }
  std::vector<std::vector<std::size_t>> groups(p.crowds.size());
  for (std::size_t i = 0; i < root.size(); ++i) groups[find(i)].push_back(i);
  std::erase_if(groups, [](const auto& group) { return group.empty(); });
  return groups;
}

class Group {
 public:
  Group(const SelectionProblem& p, std::vector<std::size_t> members)
      : p_{p}, price_{price_of(p)}, members_{std::move(members)} {
    for (const Interplay& i : p.interplays) {
      const auto at = std::find(members_.begin(), members_.end(), i.first);
      if (at != members_.end()) inner_.push_back(&i);
    }
  }

  bool is_chain() const {
    return std::all_of(inner_.begin(), inner_.end(), [&](const Interplay* i) {
      const auto at = std::find(members_.begin(), members_.end(), i->first);
      return at + 1 != members_.end() && *(at + 1) == i->second;
    });
  }

  double selections() const {
    double product = 1;
    for (const std::size_t m : members_) product *= static_cast<double>(p_.crowds[m].size());
    return product;
  }

  void along_chain(Selection& best) const {
    std::vector<double> cost;                      // of the best way to each option
    std::vector<std::vector<std::uint16_t>> from;  // the option before on that way
    for (std::size_t k = 0; k < members_.size(); ++k) {
      const std::size_t options = p_.crowds[members_[k]].size();
      std::vector<double> next(options, INFINITY);
      std::vector<std::uint16_t> before(options, 0);
      for (std::size_t o = 0; o < options; ++o) {
        const double own = own_cost(p_, price_, members_[k], o);
        if (k == 0) next[o] = own;
        for (std::size_t b = 0; b < cost.size(); ++b) {
          const double sum = cost[b] + own + joined(members_[k - 1], b, members_[k], o);
          if (sum < next[o]) {
            next[o] = sum;
            before[o] = static_cast<std::uint16_t>(b);
          }
        }
      }
      cost = std::move(next);
      from.push_back(std::move(before));
    }
    auto option =
        static_cast<std::uint16_t>(std::min_element(cost.begin(), cost.end()) - cost.begin());
    for (std::size_t k = members_.size(); k-- > 0;) {
      best[members_[k]] = option;
      option = from[k][option];
    }
  }

  void enumerated(Selection& best) const {
    Selection trial(p_.crowds.size(), 0);
    double least = INFINITY;
    for (;;) {
      const double cost = cost_of(trial);
      if (cost < least) {
        least = cost;
        for (const std::size_t m : members_) best[m] = trial[m];
      }
      std::size_t k = 0;
      while (k < members_.size() && ++trial[members_[k]] == p_.crowds[members_[k]].size()) {
        trial[members_[k++]] = 0;
      }
      if (k == members_.size()) return;
    }
  }

 private:
  double joined(std::size_t a, std::size_t option_a, std::size_t b, std::size_t option_b) const {
    for (const Interplay* i : inner_) {
      if (i->first == a && i->second == b) {
        return shared_cost(p_, price_, *i, option_a, option_b);
      }
    }
    return 0;
  }

  double cost_of(const Selection& trial) const {
    double sum = 0;
    for (const std::size_t m : members_) sum += own_cost(p_, price_, m, trial[m]);
    for (const Interplay* i : inner_) {
      sum += shared_cost(p_, price_, *i, trial[i->first], trial[i->second]);
    }
    return sum;
  }

  const SelectionProblem& p_;
  Price price_;
  std::vector<std::size_t> members_;
  std::vector<const Interplay*> inner_;
};

}  // namespace

double fitness(const SelectionProblem& p, const Selection& selection) {
  require(selection.size() == p.crowds.size(), "a selection has one option of each crowd");
  const Price price = price_of(p);
  double sum = p.length_weight;
  for (std::size_t i = 0; i < selection.size(); ++i) sum += own_cost(p, price, i, selection[i]);
  for (const Interplay& i : p.interplays) {
    sum += shared_cost(p, price, i, selection[i.first], selection[i.second]);
  }
  return sum;
}

Selection greedy_selection(const SelectionProblem& p) {
  const Price price = price_of(p);
  Selection made(p.crowds.size(), 0);
  for (std::size_t i = 0; i < made.size(); ++i) {
    for (std::size_t o = 1; o < p.crowds[i].size(); ++o) {
      if (own_cost(p, price, i, o) < own_cost(p, price, i, made[i])) {
        made[i] = static_cast<std::uint16_t>(o);
      }
    }
  }
  return made;
}

std::optional<Selection> exact_selection(const SelectionProblem& p, double most) {
  Selection best(p.crowds.size(), 0);
  for (auto& members : groups_of(p)) {
    const Group group{p, std::move(members)};
    if (group.is_chain()) {
      group.along_chain(best);
    } else if (group.selections() <= most) {
      group.enumerated(best);
    } else {
      return std::nullopt;
    }
  }
  return best;
}

}  // namespace furrow::planner
