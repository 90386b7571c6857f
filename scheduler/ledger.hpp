#pragma once
// The books of the work: what became of every cell, and on which evidence.

#include "core/messages.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace furrow::scheduler {

enum class CellState : std::uint8_t {
  open,       ///< Nobody may spray it yet.
  granted,    ///< Within an open window of one agent.
  sprayed,    ///< Proven by a closure.
  abandoned,  ///< Given up before anyone was allowed to spray it.
  uncertain,  ///< Given up while granted: it may have been sprayed.
};

struct CellCounts {
  std::uint32_t open = 0, granted = 0, sprayed = 0, abandoned = 0, uncertain = 0;
};

/// What `book` made of a closure.
enum class Booking {
  booked,   ///< New evidence, now in the books.
  known,    ///< Booked before; nothing changed.
  refused,  ///< Contradicts the books; nothing changed.
};

/// The state of every cell of a route, and each agent's windows. A cell is granted only while it is
/// open, and becomes open again only by a closure that proves it was not sprayed, so no cell is
/// sprayed twice.
class Ledger {
 public:
  explicit Ledger(std::uint32_t cells) : cells_(cells, CellState::open) { counts_.open = cells; }

  /// Releases `cells` to `agent`.
  /// @return  The window, with the agent's next id.
  /// @pre Every one of the cells is open.
  GrantWindow grant(AgentId agent, CellRange cells);

  /// Books what `agent` says of one of its windows: its first cells sprayed, the rest open again.
  Booking book(AgentId agent, const Closure& closure);

  /// Gives up every open cell within `range`.
  /// @return  The runs given up, in order.
  std::vector<CellRange> abandon(CellRange range);

  /// Gives up the open windows of an agent that will not be heard of again.
  /// @return  The runs that are uncertain now, in order of grant.
  std::vector<CellRange> forsake(AgentId agent);

  /// The first run of open cells within `range`.
  std::optional<CellRange> first_open(CellRange range) const;

  /// The open windows of an agent, oldest first.
  std::vector<GrantWindow> windows(AgentId agent) const;

  /// Every window of the agent up to this id is closed; 0 before the first.
  std::uint64_t closed_through(AgentId agent) const;
  std::uint64_t last_granted(AgentId agent) const;
  /// The highest id of a closure in the books, 0 before the first.
  std::uint64_t last_booked(AgentId agent) const;

  CellState state(std::uint32_t cell) const { return cells_.at(cell); }
  const CellCounts& counts() const { return counts_; }

 private:
  struct Account {
    std::uint64_t last_granted = 0, last_booked = 0;
    std::map<std::uint64_t, CellRange> open{};
  };

  std::uint32_t& count(CellState state);
  void set(CellRange cells, CellState state);

  std::vector<CellState> cells_;
  CellCounts counts_;
  std::map<AgentId, Account> accounts_;
};

}  // namespace furrow::scheduler
