#include "planner/survey/rounds.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

namespace furrow::planner {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double gain_s = 1e-6;
constexpr int most_looks = 200'000;

using Round = std::vector<std::uint32_t>;

struct Ends {
  double visited_s = 0.0, landed_s = 0.0;
};

class Search {
 public:
  Search(const VisitProblem& problem, std::span<const std::uint32_t> tour)
      : problem_{problem}, rounds_{cut(tour)} {
    for (std::size_t u = 0; u < rounds_.size(); ++u) ends_.push_back(ends(u, rounds_[u]));
  }

  Rounds improved() && {
    while (looks_ < most_looks && (move_any() || reverse_any())) {
    }
    return std::move(rounds_);
  }

 private:
  double between_m(std::uint32_t i, std::uint32_t j) const {
    return problem_.between_m[std::size_t{i} * problem_.places + j];
  }

  Ends ends(std::size_t u, const Round& round) const {
    if (round.empty()) return {};
    const VisitProblem::Visitor& v = problem_.visitors[u];
    double way_m = v.out_m[round.front()];
    for (std::size_t k = 1; k < round.size(); ++k) way_m += between_m(round[k - 1], round[k]);
    const double visited_s = v.ready_s + way_m / v.mps;
    return {visited_s, visited_s + problem_.back_m[round.back()] / v.mps};
  }

  // The run of the tour in the direction that ends earlier, and when.
  std::tuple<double, bool> run(std::size_t u, std::uint32_t first, std::uint32_t last,
                               double along_m) const {
    const VisitProblem::Visitor& v = problem_.visitors[u];
    const double ahead_m = v.out_m[first] + along_m, back_m = v.out_m[last] + along_m;
    return {v.ready_s + std::min(ahead_m, back_m) / v.mps, back_m < ahead_m};
  }

  // By how many places of the tour the visitors so far take, the least latest end, and where the
  // last of them begins for it.
  Rounds cut(std::span<const std::uint32_t> tour) const {
    const std::size_t n = tour.size(), visitors = problem_.visitors.size();
    std::vector<double> at_m(n, 0.0);
    for (std::size_t k = 1; k < n; ++k) at_m[k] = at_m[k - 1] + between_m(tour[k - 1], tour[k]);
    std::vector<std::vector<std::size_t>> begins(visitors, std::vector<std::size_t>(n + 1, 0));
    std::vector<double> latest_s(n + 1, infinite);
    latest_s[0] = 0.0;
    for (std::size_t u = 0; u < visitors; ++u) {
      std::vector<double> next_s = latest_s;
      for (std::size_t stop = 0; stop <= n; ++stop) {
        begins[u][stop] = stop;
        for (std::size_t first = 0; first < stop; ++first) {
          if (latest_s[first] >= next_s[stop]) continue;
          const auto [end_s, turned] =
              run(u, tour[first], tour[stop - 1], at_m[stop - 1] - at_m[first]);
          const double both_s = std::max(latest_s[first], end_s);
          if (both_s >= next_s[stop]) continue;
          next_s[stop] = both_s;
          begins[u][stop] = first;
        }
      }
      latest_s = std::move(next_s);
    }
    Rounds all(visitors);
    std::size_t stop = n;
    for (std::size_t u = visitors; u-- > 0;) {
      const std::size_t first = begins[u][stop];
      if (first == stop) continue;
      all[u].assign(tour.begin() + static_cast<std::ptrdiff_t>(first),
                    tour.begin() + static_cast<std::ptrdiff_t>(stop));
      const auto [end_s, turned] =
          run(u, tour[first], tour[stop - 1], at_m[stop - 1] - at_m[first]);
      if (turned) std::reverse(all[u].begin(), all[u].end());
      stop = first;
    }
    return all;
  }

  std::tuple<double, double> worth() const {
    double latest_s = 0.0, sum_s = 0.0;
    for (const Ends& e : ends_) {
      latest_s = std::max(latest_s, e.visited_s);
      sum_s += e.landed_s;
    }
    return {latest_s, sum_s};
  }

  // Keeps the other rounds of two visitors, or of one twice, if they are worth it.
  bool keeps(std::size_t a, Round round_a, std::size_t b, Round round_b) {
    ++looks_;
    const auto [latest_s, sum_s] = worth();
    const Ends before_a = ends_[a], before_b = ends_[b];
    ends_[a] = ends(a, round_a);
    ends_[b] = ends(b, round_b);
    const auto [now_s, now_sum_s] = worth();
    const bool is_better =
        now_s < latest_s - gain_s || (now_s <= latest_s && now_sum_s < sum_s - gain_s);
    if (is_better) {
      rounds_[a] = std::move(round_a);
      rounds_[b] = std::move(round_b);
    } else {
      ends_[a] = before_a;
      ends_[b] = before_b;
    }
    return is_better;
  }

  bool move_any() {
    for (std::size_t a = 0; a < rounds_.size(); ++a) {
      for (std::size_t k = 0; k < rounds_[a].size(); ++k) {
        if (move(a, k)) return true;
      }
    }
    return false;
  }

  bool move(std::size_t a, std::size_t k) {
    const std::uint32_t place = rounds_[a][k];
    Round without = rounds_[a];
    without.erase(without.begin() + static_cast<std::ptrdiff_t>(k));
    for (std::size_t b = 0; b < rounds_.size(); ++b) {
      const Round& to = a == b ? without : rounds_[b];
      for (std::size_t at = 0; at <= to.size(); ++at) {
        if (looks_ >= most_looks) return false;
        Round with = to;
        with.insert(with.begin() + static_cast<std::ptrdiff_t>(at), place);
        if (keeps(a, a == b ? with : without, b, with)) return true;
      }
    }
    return false;
  }

  bool reverse_any() {
    for (std::size_t a = 0; a < rounds_.size(); ++a) {
      for (std::size_t first = 0; first < rounds_[a].size(); ++first) {
        for (std::size_t stop = first + 2; stop <= rounds_[a].size(); ++stop) {
          if (looks_ >= most_looks) return false;
          Round other = rounds_[a];
          std::reverse(other.begin() + static_cast<std::ptrdiff_t>(first),
                       other.begin() + static_cast<std::ptrdiff_t>(stop));
          if (keeps(a, other, a, other)) return true;
        }
      }
    }
    return false;
  }

  const VisitProblem& problem_;
  Rounds rounds_;
  std::vector<Ends> ends_{};
  int looks_ = 0;
};

}  // namespace

Rounds rounds(const VisitProblem& problem, std::span<const std::uint32_t> tour) {
  return Search{problem, tour}.improved();
}

}  // namespace furrow::planner
