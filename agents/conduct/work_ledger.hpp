#pragma once

#include "agents/conduct/order.hpp"
#include "core/messages.hpp"

#include <cstdint>
#include <set>
#include <vector>

namespace furrow::agents {

/// An agent's side of the grant protocol: which windows it holds, and what became of them until
/// the scheduler has it on its books. Losing, repeating or reordering messages does no harm.
class WorkLedger {
 public:
  /// Takes the windows that are new. Windows at or below the last accepted id are ignored, so are
  /// messages of another epoch or revision than the order's.
  /// @return  Whether any window was taken.
  bool accept(const WorkGrant& grant, const Order& order);

  /// One past the last cell that may be sprayed without a break from `cell` on; `cell` if none.
  std::uint32_t licensed_to(std::uint32_t cell) const;

  /// Books one cell as sprayed. @return Whether it closed its window.
  /// @pre licensed_to(cell) > cell
  bool spray(std::uint32_t cell, Instant at);

  /// Closes every window as it is, oldest first.
  void close_all(CloseReason reason, Instant at);

  /// The same because an obstacle blocks `cell`: only its window for that reason, and the others as
  /// superseded.
  void close_blocked(std::uint32_t cell, Instant at);

  /// Whether all that is left of the open windows is work of `order`.
  bool fits(const Order& order) const;

  /// Forgets everything: ids begin again with a new epoch.
  void restart() { *this = {}; }

  std::uint64_t last_accepted() const { return last_accepted_; }
  std::uint64_t last_closed() const { return last_closed_; }
  /// Not yet booked by the scheduler, oldest first.
  const std::vector<Closure>& closures() const { return closures_; }
  const std::set<std::uint32_t>& sprayed_cells() const { return sprayed_; }

 private:
  struct Open {
    GrantWindow window;
    std::uint32_t sprayed;
  };
  void close(const Open& open, CloseReason reason, Instant at);

  std::vector<Open> open_;
  std::vector<Closure> closures_;
  std::set<std::uint32_t> sprayed_;
  std::uint64_t last_accepted_ = 0, last_closed_ = 0;
};

}  // namespace furrow::agents
