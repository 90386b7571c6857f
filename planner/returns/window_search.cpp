#include "planner/returns/window_search.hpp"

#include <algorithm>
#include <limits>

namespace furrow::planner {
namespace {

constexpr std::size_t buckets = 128;
constexpr std::uint32_t nobody = std::numeric_limits<std::uint32_t>::max();

// A plan so far, on landing at a candidate.
struct Label {
  double cost_s = std::numeric_limits<double>::infinity();
  double used_s = 0.0;  // of the pack on board
  std::uint32_t parent = nobody;
  bool exists() const { return cost_s < std::numeric_limits<double>::infinity(); }
};

class Table {
 public:
  Table(const ReturnCost& cost, const BatteryFree& free, std::span<const std::uint32_t> candidates,
        double cutoff_s)
      : cost_{cost}, free_{free}, cutoff_s_{cutoff_s} {
    for (const std::uint32_t c : candidates) {
      if (free.until_s[c] + free.after_s[c] < cutoff_s) stops_.push_back(c);
    }
    stops_.push_back(cost.last_cell());
    labels_.resize(stops_.size() * buckets);
  }

  Returns solve() {
    for (std::size_t to = 0; to < stops_.size() && stops_[to] <= cost_.tank_reach(0); ++to) {
      if (!cost_.carries(0, stops_[to])) continue;
      offer(to, {.cost_s = 0.0, .used_s = cost_.flight_s(0, stops_[to])});
    }
    for (std::size_t from = 0; from + 1 < stops_.size(); ++from) leave(from);
    return traced();
  }

 private:
  void leave(std::size_t from) {
    const std::uint32_t first = stops_[from];
    const double least_s = gather_live(from);
    if (live_.empty()) return;
    for (std::size_t to = from + 1; to < stops_.size(); ++to) {
      const std::uint32_t last = stops_[to];
      if (last > cost_.tank_reach(first)) break;
      const double flight_s = cost_.flight_s(first, last);
      if (flight_s > cost_.limits().pack_s) continue;
      const double spray_m = cost_.spray_m(first, last);
      const double trip_s = 2.0 * cost_.home_s(first);
      const double kept_s = trip_s + cost_.service_s(spray_m, false);
      if (is_hopeless(last, least_s + kept_s)) continue;
      const double fresh_s = trip_s + cost_.service_s(spray_m, true);
      for (const std::uint32_t parent : live_) {
        const Label& l = labels_[parent];
        const bool swap = l.used_s + flight_s > cost_.limits().pack_s;
        offer(to, {.cost_s = l.cost_s + (swap ? fresh_s : kept_s),
                   .used_s = swap ? flight_s : l.used_s + flight_s,
                   .parent = parent});
      }
    }
  }

  // The labels at a stop into `live_`; returns the least cost among them.
  double gather_live(std::size_t stop) {
    live_.clear();
    double least_s = std::numeric_limits<double>::infinity();
    for (std::size_t i = stop * buckets; i < (stop + 1) * buckets; ++i) {
      if (!labels_[i].exists()) continue;
      live_.push_back(static_cast<std::uint32_t>(i));
      least_s = std::min(least_s, labels_[i].cost_s);
    }
    return least_s;
  }

  // Whether no plan that lands at `cell` for this cost beats the cutoff.
  bool is_hopeless(std::uint32_t cell, double cost_s) const {
    const double landing_s = cell == cost_.last_cell() ? 0.0 : cost_.home_s(cell);
    return cost_s + landing_s + free_.after_s[cell] >= cutoff_s_;
  }

  void offer(std::size_t to, const Label& label) {
    if (is_hopeless(stops_[to], label.cost_s)) return;
    const double share = label.used_s / cost_.limits().pack_s;
    const auto b = std::min(static_cast<std::size_t>(share * buckets), buckets - 1);
    Label& kept = labels_[to * buckets + b];
    if (label.cost_s < kept.cost_s) kept = label;
  }

  Returns traced() const {
    const auto ends = labels_.end() - static_cast<long>(buckets);
    const auto best = std::min_element(
        ends, labels_.end(), [](const Label& a, const Label& b) { return a.cost_s < b.cost_s; });
    Returns returns;
    for (std::uint32_t at = best->parent; at != nobody; at = labels_[at].parent) {
      returns.push_back(stops_[at / buckets]);
    }
    std::reverse(returns.begin(), returns.end());
    return returns;
  }

  const ReturnCost& cost_;
  const BatteryFree& free_;
  double cutoff_s_;
  std::vector<std::uint32_t> stops_;  // candidates, then the last cell
  std::vector<Label> labels_;         // by stop, by bucket
  std::vector<std::uint32_t> live_;   // labels of the stop that is being left
};

}  // namespace

std::vector<std::uint32_t> cells_in(Windows windows, std::span<const std::uint32_t> returns,
                                    std::span<const std::uint32_t> ends, std::uint32_t last_cell) {
  std::vector<std::uint32_t> cells{ends.begin(), ends.end()};
  for (const std::uint32_t r : returns) {
    const std::uint32_t steps_down = std::min(windows.half_width, r) / windows.stride;
    const std::uint32_t highest = std::min(r + windows.half_width, last_cell);
    for (std::uint32_t c = r - steps_down * windows.stride; c <= highest; c += windows.stride) {
      cells.push_back(c);
    }
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  std::erase_if(cells, [&](std::uint32_t c) { return c == 0 || c >= last_cell; });
  return cells;
}

Returns best_among(const ReturnCost& cost, const BatteryFree& free,
                   std::span<const std::uint32_t> candidates, double cutoff_s) {
  return Table{cost, free, candidates, cutoff_s}.solve();
}

}  // namespace furrow::planner
