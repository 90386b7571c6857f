#include "planner/routes/asymmetric_crossover.hpp"

#include "core/require.hpp"

#include <algorithm>

namespace furrow::planner {
namespace {

using Cells = std::vector<std::uint64_t>;

bool holds(const Cells& cells, std::uint64_t cell) {
  return std::find(cells.begin(), cells.end(), cell) != cells.end();
}

void add_new(WayPoint gene, const Partition& partition, Genes& genes, Cells& cells) {
  const std::uint64_t cell = partition.cell(gene);
  if (holds(cells, cell)) return;
  cells.push_back(cell);
  genes.push_back(gene);
}

Genes mapped(const Genes& a, std::size_t head, const Genes& b, std::size_t tail,
             const Partition& partition) {
  Genes child;
  Cells cells;
  for (std::size_t i = 0; i < head; ++i) add_new(a[i], partition, child, cells);
  // The gene of a's tail that was exchanged for a gene of b's tail in the same cell.
  const auto partner = [&](std::uint64_t cell) -> const WayPoint* {
    for (std::size_t i = 0; tail + i < b.size() && head + i < a.size(); ++i) {
      if (partition.cell(b[tail + i]) == cell) return &a[head + i];
    }
    return nullptr;
  };
  for (std::size_t i = tail; i < b.size(); ++i) {
    const WayPoint* gene = &b[i];
    for (std::size_t step = 0; gene && holds(cells, partition.cell(*gene)); ++step) {
      gene = step < b.size() ? partner(partition.cell(*gene)) : nullptr;
    }
    if (gene) add_new(*gene, partition, child, cells);
  }
  return child;
}

Genes ordered(const Genes& a, std::size_t head, const Genes& b, std::size_t tail,
              const Partition& partition) {
  Genes kept;
  Cells cells;
  for (std::size_t i = tail; i < b.size(); ++i) add_new(b[i], partition, kept, cells);
  Genes child;
  for (std::size_t i = 0; i < a.size() && child.size() < head; ++i) {
    add_new(a[i], partition, child, cells);
  }
  child.insert(child.end(), kept.begin(), kept.end());
  return child;
}

}  // namespace

Partition::Partition(const Scene& scene, std::uint32_t intervals)
    : low_{scene.low}, last_{intervals - 1.0}, intervals_{intervals} {
  require(intervals >= 1 && intervals <= (1u << 20),
          "a partition has 1 to 2^20 intervals per axis");
  const double n = intervals;
  per_m_ = {n / (scene.high.x_m - scene.low.x_m), n / (scene.high.y_m - scene.low.y_m),
            n / (scene.high.z_m - scene.low.z_m)};
}

std::uint64_t Partition::cell(WayPoint p) const {
  const auto part = [&](double v, double low, double per_m) {
    return static_cast<std::uint64_t>(std::clamp((v - low) * per_m, 0.0, last_));
  };
  return (part(p.x_m, low_.x_m, per_m_.x_m) * intervals_ + part(p.y_m, low_.y_m, per_m_.y_m)) *
             intervals_ +
         part(p.z_m, low_.z_m, per_m_.z_m);
}

Genes spliced(const Genes& a, std::size_t head, const Genes& b, std::size_t tail,
              const Partition& partition, DuplicateRule rule) {
  return rule == DuplicateRule::mapping ? mapped(a, head, b, tail, partition)
                                        : ordered(a, head, b, tail, partition);
}

std::pair<Genes, Genes> asymmetric_crossover(const Genes& a, const Genes& b,
                                             const Partition& partition, DuplicateRule rule,
                                             std::size_t longest, Random& random) {
  require(!a.empty() && !b.empty() && longest >= 1, "parents have genes");
  const std::size_t in_a = random.below(a.size() + 1), in_b = random.below(b.size() + 1);
  std::pair<Genes, Genes> children{spliced(a, in_a, b, in_b, partition, rule),
                                   spliced(b, in_b, a, in_a, partition, rule)};
  const auto mend = [&](Genes& child, const Genes& parent) {
    if (child.empty()) child.push_back(parent[random.below(parent.size())]);
    if (child.size() > longest) child.resize(longest);
  };
  mend(children.first, a);
  mend(children.second, b);
  return children;
}

}  // namespace furrow::planner
