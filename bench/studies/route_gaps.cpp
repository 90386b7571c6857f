#include "bench/studies/route_gaps.hpp"

#include "bench/studies/statistics.hpp"
#include "planner/routes/plan_route.hpp"
#include "tests/planner/routes/hills.hpp"

#include <fmt/format.h>

#include <array>
#include <ctime>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>
#include <tuple>

namespace furrow::studies {
namespace {

using namespace planner;

constexpr std::uint64_t scenes = 20, short_rounds = 10;
constexpr std::uint64_t first_long_seed = 100, first_short_seed = 200;
constexpr std::array<double, 3> seconds{0.1, 1, 10};
constexpr double unknown = std::numeric_limits<double>::infinity();

// Judged curves for each of `seconds`. OMPL's planners spend their time on trees that grow, so
// theirs do not rise with it.
std::array<std::uint64_t, 3> curves(RoutePlanner planner) {
  switch (planner) {
    case RoutePlanner::improved_ga:
    case RoutePlanner::plain_ga: return {20'000, 200'000, 2'000'000};
    case RoutePlanner::ants: return {12'000, 120'000, 1'200'000};
    case RoutePlanner::rrt_star: return {650, 3'700, 18'000};
    case RoutePlanner::bit_star: return {2'500, 13'000, 70'000};
    case RoutePlanner::lattice: return {20'000, 200'000, 2'000'000};
  }
  return {};
}

// Scene, planner, budget and seed; the last three as indices or numbers.
using Key = std::tuple<std::uint64_t, std::size_t, std::size_t, std::uint64_t>;

struct Outcome {
  double cost;  // infinite where the run ended without a feasible route
  double cpu_s;
};

constexpr const char* heading = "scene,planner,seconds,seed,curves,cpu_s,feasible,cost_m";

std::size_t index_of(const std::string& planner) {
  std::size_t i = 0;
  while (i < std::size(route_planners) && name(route_planners[i]) != planner) ++i;
  return i;
}

std::size_t budget_of(double s) {
  return static_cast<std::size_t>(std::find(seconds.begin(), seconds.end(), s) - seconds.begin());
}

// The table of runs, in memory and on disk.
class RunTable {
 public:
  explicit RunTable(const std::string& path) {
    read(path);
    file_.open(path, std::ios::app);
    if (runs_.empty()) file_ << heading << std::endl;
  }

  const std::map<Key, Outcome>& all() const { return runs_; }

  const Outcome& run(const Key& key) {
    const auto known = runs_.find(key);
    return known != runs_.end() ? known->second : runs_.emplace(key, made(key)).first->second;
  }

 private:
  void read(const std::string& path) {
    std::ifstream file{path};
    std::string line;
    std::getline(file, line);
    while (std::getline(file, line)) {
      std::replace(line.begin(), line.end(), ',', ' ');
      std::istringstream words{line};
      std::string planner;
      std::uint64_t scene, seed, budget;
      double s, cpu_s, cost;
      bool is_feasible;
      if (!(words >> scene >> planner >> s >> seed >> budget >> cpu_s >> is_feasible >> cost))
        break;
      runs_[{scene, index_of(planner), budget_of(s), seed}] = {is_feasible ? cost : unknown, cpu_s};
    }
  }

  Outcome made(const Key& key) {
    const auto [number, p, b, seed] = key;
    const Scene scene = hills::scene(number, number % 4);
    const RoutePlanner planner = route_planners[p];
    const std::clock_t began = std::clock();
    const Individual best = search_route(scene, {planner, curves(planner)[b], seed}).best;
    const double cpu_s = static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
    file_ << fmt::format("{},{},{},{},{},{:.3f},{:d},{:.3f}", number, name(planner), seconds[b],
                         seed, curves(planner)[b], cpu_s, best.cost.is_feasible(),
                         best.cost.total())
          << std::endl;
    return {best.cost.is_feasible() ? best.cost.total() : unknown, cpu_s};
  }

  std::map<Key, Outcome> runs_;
  std::ofstream file_;
};

// What one planner did with one budget.
struct Gaps {
  std::vector<double> of;  // above the best known, as a share; of feasible ends
  std::vector<double> cpu_s;
};

using Table = std::array<std::array<Gaps, seconds.size()>, std::size(route_planners)>;

std::vector<double> best_known(RunTable& runs, std::uint64_t rounds) {
  const auto take = [&](std::size_t budget, std::uint64_t seed) {
    for (std::uint64_t scene = 0; scene < scenes; ++scene) {
      for (std::size_t p = 0; p < std::size(route_planners); ++p)
        runs.run({scene, p, budget, seed});
    }
  };
  for (std::size_t budget = 0; budget < seconds.size(); ++budget) take(budget, 1);
  for (std::uint64_t round = 0; round < short_rounds; ++round) take(0, first_short_seed + round);
  for (std::uint64_t round = 0; round < rounds; ++round) {
    take(seconds.size() - 1, first_long_seed + round);
  }
  std::vector<double> best(scenes, unknown);
  for (const auto& [key, one] : runs.all()) {
    double& least = best[std::get<0>(key)];
    least = std::min(least, one.cost);
  }
  return best;
}

Table gaps(RunTable& runs, const std::vector<double>& best) {
  Table table;
  for (std::size_t p = 0; p < table.size(); ++p) {
    for (std::size_t b = 0; b < seconds.size(); ++b) {
      for (std::uint64_t scene = 0; scene < scenes; ++scene) {
        const Outcome& one = runs.run({scene, p, b, 1});
        table[p][b].cpu_s.push_back(one.cpu_s);
        if (one.cost < unknown) table[p][b].of.push_back(one.cost / best[scene] - 1);
      }
    }
  }
  return table;
}

void print(const Table& table) {
  fmt::print(
      "| | budget | feasible | mean gap of those | median | worst | processor time |\n"
      "|---|---|---|---|---|---|---|\n");
  for (std::size_t p = 0; p < table.size(); ++p) {
    for (std::size_t b = 0; b < seconds.size(); ++b) {
      const Gaps& one = table[p][b];
      fmt::print("| {} | {} s | {} of {} | {:.2f} % | {:.2f} % | {:.2f} % | {:.2f} s |\n",
                 b == 0 ? name(route_planners[p]) : "", seconds[b], one.of.size(), scenes,
                 100 * mean(one.of), 100 * median(one.of), 100 * worst(one.of), mean(one.cpu_s));
    }
  }
}

// Mean gap against budget, both by their logarithm; the worst as a dot above.
void draw(const std::string& path, const Table& table) {
  constexpr double left = 70, top = 40, wide = 420, high = 380;
  constexpr double least = 0.01, most = 40;  // percent
  const char* const colours[] = {"#c0392b", "#2471a3", "#117a65", "#b9770e", "#7d3c98", "#34495e"};
  const auto x_of = [&](std::size_t b) {
    return left + wide * (0.08 + 0.42 * static_cast<double>(b));
  };
  const auto y_of = [&](double share) {
    const double percent = std::clamp(100 * share, least, most);
    return top + high * std::log(most / percent) / std::log(most / least);
  };
  std::ofstream svg{path};
  svg << fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{:.0f}\" height=\"{:.0f}\" "
      "font-family=\"sans-serif\" font-size=\"13\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
      "<text x=\"{}\" y=\"24\">gap to the best known, mean (line) and worst (ring) of {} "
      "scenes</text>\n",
      left + wide + 160, top + high + 50, left, scenes);
  for (const double tick : {0.01, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0, 30.0}) {
    svg << fmt::format(
        "<path d=\"M{0} {1:.1f}h{2}\" stroke=\"#ddd\"/><text x=\"{3}\" y=\"{4:.1f}\" "
        "text-anchor=\"end\">{5} %</text>\n",
        left, y_of(tick / 100), wide, left - 6, y_of(tick / 100) + 4, tick);
  }
  for (std::size_t b = 0; b < seconds.size(); ++b) {
    svg << fmt::format("<text x=\"{:.0f}\" y=\"{}\" text-anchor=\"middle\">{} s</text>\n", x_of(b),
                       top + high + 24, seconds[b]);
  }
  for (std::size_t p = 0; p < table.size(); ++p) {
    std::string line;
    for (std::size_t b = 0; b < seconds.size(); ++b) {
      const Gaps& one = table[p][b];
      line += fmt::format("{:.1f},{:.1f} ", x_of(b), y_of(mean(one.of)));
      svg << fmt::format(
          "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" fill=\"none\" "
          "stroke=\"{}\"/>\n",
          x_of(b), y_of(worst(one.of)), colours[p]);
    }
    svg << fmt::format(
        "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"/>\n"
        "<text x=\"{}\" y=\"{}\" fill=\"{}\">{}</text>\n",
        line, colours[p], left + wide + 16, top + 20 + 22 * static_cast<double>(p), colours[p],
        name(route_planners[p]));
  }
  svg << "</svg>\n";
}

}  // namespace

void route_gaps(const std::string& runs, const std::string& picture, std::uint64_t rounds) {
  RunTable all{runs};
  const Table table = gaps(all, best_known(all, rounds));
  print(table);
  draw(picture, table);
}

}  // namespace furrow::studies
