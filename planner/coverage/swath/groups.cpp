#include "planner/coverage/swath/groups.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace furrow::planner {
namespace {

constexpr double longest_jump = 4.0;  // swaths

struct Beside {
  int count = 0;
  std::size_t chord = 0;  // the last one seen
};

// For every chord, those of the next row that overlap it, and the reverse.
struct Neighbours {
  std::vector<Beside> above, below;
};

Neighbours neighbours_of(const std::vector<Chord>& chords) {
  Neighbours n{std::vector<Beside>(chords.size()), std::vector<Beside>(chords.size())};
  std::size_t next = 0;
  for (std::size_t i = 0; i < chords.size(); ++i) {
    while (next < chords.size() && chords[next].row <= chords[i].row) ++next;
    // Rows hold few chords; the next row is scanned whole.
    for (std::size_t j = next; j < chords.size() && chords[j].row == chords[i].row + 1; ++j) {
      if (std::min(chords[i].high_m, chords[j].high_m) <=
          std::max(chords[i].low_m, chords[j].low_m)) {
        continue;
      }
      ++n.above[i].count;
      n.above[i].chord = j;
      ++n.below[j].count;
      n.below[j].chord = i;
    }
  }
  return n;
}

bool belong_together(const Chord& a, const Chord& b, double swath_m) {
  const double jump_m = longest_jump * swath_m;
  const bool left = a.left_edge == b.left_edge || std::abs(a.low_m - b.low_m) <= jump_m;
  const bool right = a.right_edge == b.right_edge || std::abs(a.high_m - b.high_m) <= jump_m;
  return left && right;
}

}  // namespace

std::vector<StripGroup> strip_groups(const Sweep& sweep, double swath_m) {
  const std::vector<Chord>& chords = sweep.chords;
  const Neighbours n = neighbours_of(chords);
  std::vector<std::size_t> group_of(chords.size());
  std::vector<StripGroup> groups;
  for (std::size_t i = 0; i < chords.size(); ++i) {
    const bool joins = n.below[i].count == 1 && n.above[n.below[i].chord].count == 1 &&
                       belong_together(chords[n.below[i].chord], chords[i], swath_m);
    group_of[i] = joins ? group_of[n.below[i].chord] : groups.size();
    if (!joins) groups.emplace_back();
    const Row& row = sweep.rows[chords[i].row];
    groups[group_of[i]].strips.push_back({sweep.frame.from({chords[i].low_m, row.v_m}),
                                          sweep.frame.from({chords[i].high_m, row.v_m}),
                                          row.half_width_m});
  }
  return groups;
}

}  // namespace furrow::planner
