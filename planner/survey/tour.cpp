#include "planner/survey/tour.hpp"

#include "core/require.hpp"

#include <algorithm>

namespace furrow::planner {
namespace {

constexpr double worth_a_change = 1e-9;
constexpr std::size_t longest_move = 3;

class Tour {
 public:
  Tour(std::uint32_t places, const std::function<double(std::uint32_t, std::uint32_t)>& length)
      : places_{places} {
    for (std::uint32_t i = 0; i < places; ++i) {
      for (std::uint32_t j = 0; j < places; ++j) {
        lengths_.push_back(j < i ? lengths_[j * places + i] : j == i ? 0 : length(i, j));
      }
    }
  }

  std::vector<std::uint32_t> made() {
    visit_nearest();
    while (reverse_one() || move_one()) {
    }
    return std::move(order_);
  }

 private:
  double between(std::uint32_t a, std::uint32_t b) const { return lengths_[a * places_ + b]; }
  // Behind the last comes the first.
  std::uint32_t at(std::size_t i) const { return order_[i % order_.size()]; }

  void visit_nearest() {
    std::vector<bool> is_visited(places_);
    order_.push_back(0);
    is_visited[0] = true;
    while (order_.size() < places_) {
      std::uint32_t nearest = places_;
      for (std::uint32_t p = 0; p < places_; ++p) {
        if (is_visited[p]) continue;
        const bool is_nearer =
            nearest == places_ || between(order_.back(), p) < between(order_.back(), nearest);
        if (is_nearer) nearest = p;
      }
      order_.push_back(nearest);
      is_visited[nearest] = true;
    }
  }

  // Of the places i .. j, none of them the first.
  bool reverse_one() {
    for (std::size_t i = 1; i < order_.size(); ++i) {
      for (std::size_t j = i + 1; j < order_.size(); ++j) {
        const double now = between(at(i - 1), at(i)) + between(at(j), at(j + 1));
        const double then = between(at(i - 1), at(j)) + between(at(i), at(j + 1));
        if (then >= now - worth_a_change) continue;
        std::reverse(iter(i), iter(j + 1));
        return true;
      }
    }
    return false;
  }

  // A stretch i .. j goes behind place k.
  bool move_one() {
    for (std::size_t i = 1; i < order_.size(); ++i) {
      for (std::size_t j = i; j < std::min(i + longest_move, order_.size()); ++j) {
        const double saved =
            between(at(i - 1), at(i)) + between(at(j), at(j + 1)) - between(at(i - 1), at(j + 1));
        for (std::size_t k = 0; k < order_.size(); ++k) {
          if (k + 1 >= i && k <= j) continue;
          const double added =
              between(at(k), at(i)) + between(at(j), at(k + 1)) - between(at(k), at(k + 1));
          if (added >= saved - worth_a_change) continue;
          if (k < i) {
            std::rotate(iter(k + 1), iter(i), iter(j + 1));
          } else {
            std::rotate(iter(i), iter(j + 1), iter(k + 1));
          }
          return true;
        }
      }
    }
    return false;
  }

  std::vector<std::uint32_t>::iterator iter(std::size_t i) {
    return order_.begin() + static_cast<std::ptrdiff_t>(i);
  }

  std::uint32_t places_;
  std::vector<double> lengths_{};
  std::vector<std::uint32_t> order_{};
};

}  // namespace

std::vector<std::uint32_t> tour(std::uint32_t places,
                                const std::function<double(std::uint32_t, std::uint32_t)>& length) {
  require(places > 0, "a tour has a place");
  return Tour{places, length}.made();
}

}  // namespace furrow::planner
