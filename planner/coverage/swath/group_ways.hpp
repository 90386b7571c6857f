#pragma once

#include "planner/coverage/swath/groups.hpp"
#include "planner/coverage/swath/inside_paths.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace furrow::planner {

/// One of the four ways to fly a group: from its first or last strip, from end a or end b of it.
struct Sense {
  bool from_last, from_b;
};

/// How groups of strips can be flown, and the ways between them.
class GroupWays {
 public:
  static constexpr std::size_t senses = 4;

  GroupWays(const std::vector<StripGroup>& groups, const InsidePaths& paths,
            std::optional<PointM> start);

  std::size_t size() const { return groups_.size(); }
  static Sense sense(std::size_t number) { return {(number & 2) != 0, (number & 1) != 0}; }

  /// Whether a group may be flown so: a chain has two senses, 0 and 3.
  bool allows(std::size_t group, std::size_t sense) const {
    const Flown flown = groups_[group].flown;
    return sense == 0 || flown == Flown::to_and_fro || (sense == 3 && flown == Flown::in_a_chain);
  }
  PointM entry(std::size_t group, std::size_t sense) const { return ends_[group][sense].entry; }
  PointM exit(std::size_t group, std::size_t sense) const { return ends_[group][sense].exit; }
  /// The sense that flies the group backwards.
  std::size_t reversed(std::size_t group, std::size_t sense) const;
  /// Length of the turns inside the group.
  double turns_m(std::size_t group, std::size_t sense) const { return ends_[group][sense].turns_m; }
  /// Length of the shortest inside way from the exit of one to the entry of another.
  double way_m(std::size_t from, std::size_t from_sense, std::size_t to,
               std::size_t to_sense) const;
  /// The straight distance, at most `way_m`.
  double straight_m(std::size_t from, std::size_t from_sense, std::size_t to,
                    std::size_t to_sense) const {
    return norm(entry(to, to_sense) - exit(from, from_sense));
  }
  /// From the start to an entry; 0 without a start.
  double first_m(std::size_t group, std::size_t sense) const;
  /// The strips of a group in the order and direction of a sense.
  std::vector<GroundStrip> flown(std::size_t group, std::size_t sense) const;

 private:
  struct Ends {
    PointM entry, exit;
    double turns_m;
  };
  std::size_t exit_corner(std::size_t group, std::size_t sense) const;

  const std::vector<StripGroup>& groups_;
  const InsidePaths& paths_;
  std::optional<PointM> start_;
  std::vector<std::array<Ends, senses>> ends_;
  mutable std::vector<double> known_m_;  ///< Ways by pair of corners, negative if not yet asked.
};

}  // namespace furrow::planner
