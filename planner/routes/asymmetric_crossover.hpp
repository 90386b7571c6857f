#pragma once

#include "planner/routes/population.hpp"

#include <cstdint>
#include <utility>

namespace furrow::planner {

/// The scene's box in `intervals` parts per axis. Genes in one part count as the same.
class Partition {
 public:
  /// @pre 1 <= intervals <= 2^20
  Partition(const Scene& scene, std::uint32_t intervals);
  std::uint64_t cell(WayPoint p) const;

 private:
  WayPoint low_, per_m_;
  double last_;
  std::uint64_t intervals_;
};

/// What happens to genes that a child would have twice.
enum class DuplicateRule {
  mapping,  ///< Before the cut all stay; a duplicate after it becomes the gene it was exchanged
            ///< for, or that one's, until one is new; where the chain ends, it is removed.
  order,    ///< After the cut all stay; before it stand the other parent's missing genes in order.
};

/// Two children of two parents cut at places of their own: the head of each with the tail of the
/// other, without duplicates. Lengths may differ from the parents'; no child is empty or longer
/// than `longest`.
///
/// @pre parents with one gene or more; longest >= 1
/// Source: Huang et al., asymmetric mapping crossover.
std::pair<Genes, Genes> asymmetric_crossover(const Genes& a, const Genes& b,
                                             const Partition& partition, DuplicateRule rule,
                                             std::size_t longest, Random& random);

/// One child: the first `head` genes of `a` with the genes of `b` from `tail` on, without
/// duplicates; exchanged for one another are a[head + i] and b[tail + i]. May be empty.
Genes spliced(const Genes& a, std::size_t head, const Genes& b, std::size_t tail,
              const Partition& partition, DuplicateRule rule);

}  // namespace furrow::planner
