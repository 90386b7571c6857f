#pragma once

#include "planner/coverage/swath/groups.hpp"
#include "planner/coverage/swath/inside_paths.hpp"

#include <optional>
#include <vector>

namespace furrow::planner {

/// A strip in the order flown, from `strip.a` to `strip.b`.
struct OrderedStrip {
  GroundStrip strip;
  PathM approach;  ///< From the end of the strip before, both ends included; empty for the first.
};

struct StripOrder {
  std::vector<OrderedStrip> strips;
  double route_m = 0;  ///< Strips and connections.
  double bound_m = 0;  ///< No order of these groups, each flown to and fro, is shorter.
  bool exact = false;  ///< Whether no other order of the groups is shorter.
};

/// Puts groups into the order, direction and sense that make the route shortest.
///
/// Up to nine groups exactly, by dynamic programming over subsets. More: nearest neighbour,
/// improved by reversing and moving stretches until nothing helps, then the best senses for that
/// order. The bound adds up strips, cheapest turns and a minimum spanning tree of straight ways.
///
/// @param start  The route begins near it; free if left out. The way there is not part of the
/// route.
///
/// Source: Held, Karp 1962 (exact); Or 1976, Croes 1958 (improvement).
StripOrder strip_order(const std::vector<StripGroup>& groups, const InsidePaths& paths,
                       std::optional<PointM> start);

}  // namespace furrow::planner
