// The comparison of route searches over terrain, as tables in Markdown on standard output:
//
//     terrain_route_study compare PICTURE.svg     the paper's comparisons, 30 seeds
//     terrain_route_study optimality RUNS.csv PICTURE.svg ROUNDS
//                                                 the gap of every planner over 20 scenes, against
//                                                 the best of as many rounds of long runs
#include "bench/studies/route_gaps.hpp"
#include "bench/studies/statistics.hpp"
#include "planner/routes/ants.hpp"
#include "planner/routes/evolution.hpp"
#include "planner/routes/plan_route.hpp"
#include "tests/planner/routes/hills.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <functional>
#include <string>

namespace furrow::studies {
namespace {

using namespace planner;

constexpr std::uint64_t seeds = 30, evaluations = 8000, scene_number = 1;

using Search = std::function<RouteSearch(const Scene&, std::uint64_t seed)>;

struct Runs {
  std::string name;
  std::vector<double> costs;        // of the best of each seed
  std::vector<double> generations;  // until within 1 % of it
  std::vector<std::vector<double>> histories;
  double feasible = 0;
  Individual example;
};

double convergence(const std::vector<double>& history) {
  std::size_t i = 0;
  while (history[i] > 1.01 * history.back()) ++i;
  return static_cast<double>(i);
}

Runs runs(const std::string& name, const Scene& scene, const Search& search) {
  Runs all{.name = name, .costs = {}, .generations = {}, .histories = {}, .example = {}};
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    RouteSearch found = search(scene, seed);
    all.costs.push_back(found.best.cost.total());
    all.generations.push_back(convergence(found.history));
    all.feasible += found.best.cost.is_feasible();
    all.histories.push_back(std::move(found.history));
    if (seed == 0) all.example = std::move(found.best);
  }
  return all;
}

Search evolving(EvolutionSettings settings) {
  return [settings](const Scene& scene, std::uint64_t seed) {
    return evolved_route(scene, settings, evaluations, seed);
  };
}

void table(const std::vector<Runs>& rows, const Runs& against) {
  fmt::print(
      "| | mean cost | sd | worst | feasible | converged at generation | p against {} |\n"
      "|---|---|---|---|---|---|---|\n",
      against.name);
  for (const Runs& row : rows) {
    const std::string p = &row == &against || row.name == against.name
                              ? ""
                              : fmt::format("{:.1g}", rank_sum_p(row.costs, against.costs));
    fmt::print("| {} | {:.0f} | {:.0f} | {:.0f} | {:.0f} of {} | {:.1f} | {} |\n", row.name,
               mean(row.costs), deviation(row.costs), worst(row.costs), row.feasible, seeds,
               mean(row.generations), p);
  }
  fmt::print("\n");
}

// Mean best cost at 100 equal shares of the budget.
std::vector<double> course(const Runs& all) {
  std::vector<double> means;
  for (int i = 0; i <= 100; ++i) {
    double sum = 0;
    for (const auto& h : all.histories)
      sum += h[(h.size() - 1) * static_cast<std::size_t>(i) / 100];
    means.push_back(sum / static_cast<double>(all.histories.size()));
  }
  return means;
}

// Left: mean best cost over the budget. Right: the terrain from above with one route of each.
void draw(const std::string& path, const Scene& scene, const std::vector<Runs>& rows) {
  constexpr double size = 420, left = 60, top = 40, gap = 60;
  const char* const colours[] = {"#c0392b", "#2471a3", "#117a65"};
  std::ofstream svg{path};
  svg << fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{:.0f}\" height=\"{:.0f}\" "
      "font-family=\"sans-serif\" font-size=\"13\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
      2 * size + left + gap + 30, size + top + 80);
  const double low = 1300, high = 4000;
  const auto y_of = [&](double cost) {
    return top + size * std::log(high / std::clamp(cost, low, high)) / std::log(high / low);
  };
  for (const double tick : {1300.0, 1500.0, 2000.0, 2500.0, 3000.0, 4000.0}) {
    svg << fmt::format(
        "<path d=\"M{0} {1:.1f}h{2}\" stroke=\"#ddd\"/><text x=\"{3}\" y=\"{4:.1f}\" "
        "text-anchor=\"end\">{5:.0f}</text>\n",
        left, y_of(tick), size, left - 6, y_of(tick) + 4, tick);
  }
  svg << fmt::format(
      "<text x=\"{}\" y=\"24\">mean best cost, m, against share of the budget</text>\n"
      "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">0 to 100 % of {} judged curves, "
      "{} seeds</text>\n",
      left, left + size / 2, top + size + 24, evaluations, seeds);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    std::string line;
    const auto means = course(rows[r]);
    for (std::size_t i = 0; i < means.size(); ++i) {
      line +=
          fmt::format("{:.1f},{:.1f} ", left + size * static_cast<double>(i) / 100, y_of(means[i]));
    }
    svg << fmt::format(
        "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"/>\n"
        "<text x=\"{:.0f}\" y=\"{}\" fill=\"{}\">{}</text>\n",
        line, colours[r % 3], left + 150.0 * static_cast<double>(r), top + size + 50,
        colours[r % 3], rows[r].name);
  }
  const double x0 = left + size + gap, scale = size / hills::side_m;
  constexpr int cells = 60;
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      const double x = (i + 0.5) * hills::side_m / cells, y = (j + 0.5) * hills::side_m / cells;
      const double h = std::clamp(scene.surface.height_m(x, y), 0.0, 240.0);
      const int level = static_cast<int>(h / 20);  // one shade per 20 m
      svg << fmt::format(
          "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"7.2\" height=\"7.2\" "
          "fill=\"rgb({},{},{})\"/>\n",
          x0 + size * i / cells, top + size - size * (j + 1) / cells, 238 - 12 * level,
          240 - 10 * level, 222 - 14 * level);
    }
  }
  svg << fmt::format(
      "<text x=\"{}\" y=\"24\">from above: one shade per 20 m, ceiling {} m, first "
      "seed of each</text>\n",
      x0, hills::ceiling_m);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    std::string line;
    for (const WayPoint& p : flown(scene, rows[r].example.genes)) {
      line += fmt::format("{:.1f},{:.1f} ", x0 + scale * p.x_m, top + size - scale * p.y_m);
    }
    svg << fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"/>\n",
                       line, colours[r % 3]);
  }
  svg << "</svg>\n";
}

void ratios(const std::string& what, const Runs& ours, const Runs& plain,
            const std::string& paper) {
  fmt::print("{}: cost {:.0f} % lower, generation {:.1f} against {:.1f}; the paper: {}\n\n", what,
             100 * (1 - mean(ours.costs) / mean(plain.costs)), mean(ours.generations),
             mean(plain.generations), paper);
}

void compare(const std::string& picture) {
  const Scene scene = hills::scene(scene_number);
  fmt::print("### Improved GA, plain GA, ants\n\n");
  const std::vector<Runs> main_rows{runs("improved GA", scene, evolving({})),
                                    runs("plain GA", scene, evolving(plain_evolution())),
                                    runs("ants", scene, [](const Scene& s, std::uint64_t seed) {
                                      return ant_route(s, {}, evaluations, seed);
                                    })};
  table(main_rows, main_rows.front());
  draw(picture, scene, main_rows);

  fmt::print("### One operator exchanged\n\n");
  const std::vector<Runs> ablations{
      main_rows[0], runs("random mutation", scene, evolving({.mutation = Mutation::random})),
      runs("simulated binary crossover", scene,
           evolving({.crossover = Crossover::simulated_binary})),
      runs("roulette selection", scene, evolving({.selection = ParentSelection::roulette}))};
  table(ablations, ablations.front());
  ratios("Heuristic against random mutation", ablations[0], ablations[1],
         "32 % lower, generation 2 against 12");
  ratios("Asymmetric mapping against simulated binary crossover", ablations[0], ablations[2],
         "50 % lower, generation 5 against 9");

  fmt::print("### The plain GA with one improved operator\n\n");
  EvolutionSettings with_mutation = plain_evolution(), with_crossover = plain_evolution();
  with_mutation.mutation = Mutation::heuristic_multiple;
  with_crossover.crossover = Crossover::asymmetric_mapping;
  const std::vector<Runs> improved{
      main_rows[1], runs("with heuristic mutation", scene, evolving(with_mutation)),
      runs("with asymmetric crossover", scene, evolving(with_crossover))};
  table(improved, improved.front());
  ratios("Heuristic against random mutation", improved[1], improved[0],
         "32 % lower, generation 2 against 12");
  ratios("Asymmetric mapping against simulated binary crossover", improved[2], improved[0],
         "50 % lower, generation 5 against 9");

  fmt::print("### Chromosome length\n\n");
  std::vector<Runs> lengths;
  for (const std::uint32_t genes : {6u, 9u, 12u}) {
    lengths.push_back(runs(fmt::format("{} genes", genes), scene, evolving({.chromosome = genes})));
  }
  table(lengths, lengths[1]);
  lengths.clear();
  for (const std::uint32_t genes : {6u, 9u, 12u}) {
    lengths.push_back(runs(fmt::format("{} genes, plain GA", genes), scene,
                           evolving(plain_evolution({.chromosome = genes}))));
  }
  table(lengths, lengths[1]);

  fmt::print("### Rates\n\n");
  const auto with_rates = [&](double crossover, double mutation) {
    return runs(fmt::format("crossover {:.2f}, mutation {:.2f}", crossover, mutation), scene,
                evolving({.crossover_rate = crossover, .mutation_rate = mutation}));
  };
  const std::vector<Runs> rates{with_rates(0.9, 0.3), with_rates(0.3, 0.9),
                                with_rates(0.9, 1.0 / 9), with_rates(0.6, 0.9)};
  table(rates, rates.front());
}

}  // namespace
}  // namespace furrow::studies

int main(int count, char** words) {
  const std::string what = count > 1 ? words[1] : "";
  if (what == "compare" && count == 3) {
    furrow::studies::compare(words[2]);
  } else if (what == "optimality" && count == 5) {
    furrow::studies::route_gaps(words[2], words[3], std::strtoull(words[4], nullptr, 10));
  } else {
    fmt::print(stderr,
               "usage: terrain_route_study compare PICTURE.svg\n"
               "       terrain_route_study optimality RUNS.csv PICTURE.svg ROUNDS\n");
    return 2;
  }
}
