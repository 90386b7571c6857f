#pragma once

#include "core/messages.hpp"
#include "core/station.hpp"

#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace furrow::agents {

/// The command being followed and how far its work has come.
class Order {
 public:
  Order() = default;
  explicit Order(Command command) : command_{std::move(command)} {}
  /// Begins behind the cells that were sprayed already, as far as they come first.
  Order(Command command, const std::set<std::uint32_t>& sprayed);

  Epoch epoch() const { return command_.epoch; }
  std::uint32_t revision() const { return command_.revision; }
  bool is_older_than(const Command& other) const;
  const std::vector<SeenObstacle>& obstacles() const { return command_.obstacles; }
  bool is_same_as(const Command& other) const;

  /// Every cell of every sortie is sprayed.
  bool is_finished() const { return sortie_ >= command_.sorties.size(); }
  /// Index into the command's sorties.
  std::uint32_t sortie() const { return static_cast<std::uint32_t>(sortie_); }
  /// @pre !is_finished()
  StationId station() const { return command_.sorties[sortie_].station; }
  /// The cell to spray next. @pre !is_finished()
  std::uint32_t next_cell() const;

  /// What is left of the sortie: where a piece was left half-way, the rest of it continues from the
  /// last cell sprayed. @pre !is_finished()
  std::vector<Piece> rest_of_sortie() const;

  /// Books the next cell. @return Whether it ended the sortie.
  bool spray();

  /// Whether both have the same left of the sortie that each is at, to the same station.
  /// @pre Neither is finished.
  bool goes_on_as(const Order& other) const;

  /// Whether `cells` lie within one piece and none of them is sprayed yet.
  bool is_open(CellRange cells) const;

 private:
  Command command_{};
  std::size_t sortie_ = 0, piece_ = 0;
  std::uint32_t in_piece_ = 0;
};

/// Why a command cannot be followed, or nothing when it can. Its cells may come in any order, each
/// once; those that were sprayed already come before all others.
/// @param sprayed  By this aircraft in the command's epoch.
std::optional<std::string> fault_in(const Command& command, std::span<const Station> stations,
                                    const std::set<std::uint32_t>& sprayed = {});

}  // namespace furrow::agents
