#include "planner/returns/label_search.hpp"

#include <algorithm>
#include <limits>
#include <queue>
#include <vector>

namespace furrow::planner {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double improvement_s = 1e-7;  // less is rounding, not a better plan
constexpr std::uint32_t no_label = ~0u;
constexpr std::size_t max_labels = 1'000'000;  // about 40 MB with their queue

// A partial plan that ends with landing at a candidate.
struct Label {
  double cost_s;
  double used_s;  // of the pack on board
  std::uint32_t candidate, parent;
};

// All partial plans of one search.
class Labels {
 public:
  Labels(const Legs& legs, const BatteryBound& bound) : legs_{legs}, bound_{bound} {}

  // Calls `f(next label, estimate of the whole plan)` for each sortie after `from`, or for each
  // first sortie. Returns how many were looked at.
  template <class F>
  std::uint64_t for_each_next(std::uint32_t from, F f) const {
    const bool first = from == no_label;
    const std::size_t begin = first ? 0 : labels_[from].candidate + 1u;
    const std::size_t end =
        first ? bound_.first_reach_end() : bound_.reach_end(labels_[from].candidate);
    for (std::size_t d = begin; d < end; ++d) {
      const Label next = first ? first_sortie(d) : sortie(from, d);
      if (next.used_s > legs_.pack_s) continue;
      f(next, next.cost_s + bound_.after_s(d, next.used_s - legs_.landing_s[cell(d)]));
    }
    return end - begin;
  }

  std::uint32_t keep(Label label) {
    labels_.push_back(label);
    return static_cast<std::uint32_t>(labels_.size() - 1);
  }

  std::size_t size() const { return labels_.size(); }
  bool is_complete(std::uint32_t id) const { return cell(labels_[id].candidate) == legs_.last; }
  const Label& operator[](std::uint32_t id) const { return labels_[id]; }

  Returns returns_of(std::uint32_t complete) const {
    Returns returns;
    for (std::uint32_t id = labels_[complete].parent; id != no_label; id = labels_[id].parent) {
      returns.push_back(cell(labels_[id].candidate));
    }
    std::reverse(returns.begin(), returns.end());
    return returns;
  }

 private:
  std::uint32_t cell(std::size_t candidate) const { return bound_.candidates()[candidate]; }

  Label first_sortie(std::size_t d) const {
    const std::uint32_t j = cell(d);
    return {.cost_s = legs_.arrival_s(j),
            .used_s = legs_.first_offset_s + legs_.landing_s[j],
            .candidate = static_cast<std::uint32_t>(d),
            .parent = no_label};
  }

  Label sortie(std::uint32_t from, std::size_t d) const {
    const Label& label = labels_[from];
    const std::uint32_t i = cell(label.candidate), j = cell(d);
    const double flight_s =
        legs_.leave_pack_s[i] + (legs_.route_s[j] - legs_.route_s[i]) + legs_.back_pack_s[j];
    const bool swap = label.used_s + flight_s > legs_.pack_s;
    return {.cost_s =
                label.cost_s + legs_.leave_s[i] + legs_.service_s(i, j, swap) + legs_.arrival_s(j),
            .used_s = swap ? flight_s : label.used_s + flight_s,
            .candidate = static_cast<std::uint32_t>(d),
            .parent = from};
  }

  const Legs& legs_;
  const BatteryBound& bound_;
  std::vector<Label> labels_;
};

struct Open {
  double estimate_s;
  std::uint32_t candidate, id;

  // Of equal estimates the one further along the route, then the older.
  friend bool operator<(const Open& a, const Open& b) {
    if (a.estimate_s != b.estimate_s) return a.estimate_s > b.estimate_s;
    if (a.candidate != b.candidate) return a.candidate < b.candidate;
    return a.id > b.id;
  }
};

}  // namespace

SearchOutcome dive(const Legs& legs, const BatteryBound& bound, double cutoff_s,
                   std::uint64_t& work_left) {
  SearchOutcome outcome{std::nullopt, cutoff_s, 0.0, false};
  Labels labels{legs, bound};
  for (std::uint32_t at = no_label; at == no_label || !labels.is_complete(at);) {
    Label best{};
    double best_s = infinite;
    const std::uint64_t steps = labels.for_each_next(at, [&](const Label& next, double estimate_s) {
      if (estimate_s <= best_s && estimate_s < infinite) {
        best_s = estimate_s;
        best = next;
      }
    });
    work_left -= std::min(work_left, steps);
    if (best_s >= cutoff_s - improvement_s) return outcome;
    at = labels.keep(best);
    if (labels.is_complete(at)) {
      outcome.better = labels.returns_of(at);
      outcome.cost_s = best.cost_s;
    }
  }
  return outcome;
}

SearchOutcome best_first(const Legs& legs, const BatteryBound& bound, double cutoff_s,
                         std::uint64_t& work_left) {
  SearchOutcome outcome{std::nullopt, cutoff_s, cutoff_s, true};
  Labels labels{legs, bound};
  std::priority_queue<Open> open;
  const auto expand = [&](std::uint32_t from) {
    return labels.for_each_next(from, [&](const Label& next, double estimate_s) {
      if (estimate_s >= outcome.cost_s - improvement_s) return;
      const std::uint32_t id = labels.keep(next);
      open.push({estimate_s, next.candidate, id});
      if (labels.is_complete(id)) {
        outcome.cost_s = next.cost_s;
        outcome.better = labels.returns_of(id);
      }
    });
  };
  work_left -= std::min(work_left, expand(no_label));
  while (!open.empty() && open.top().estimate_s < outcome.cost_s - improvement_s) {
    const Open top = open.top();
    if (work_left == 0 || labels.size() > max_labels) {
      outcome.lower_bound_s = top.estimate_s;
      outcome.finished = false;
      return outcome;
    }
    open.pop();
    work_left -= std::min(work_left, expand(top.id));
  }
  outcome.lower_bound_s = outcome.cost_s;
  return outcome;
}

}  // namespace furrow::planner
