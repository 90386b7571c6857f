#include "agents/conduct/work_ledger.hpp"

#include "core/require.hpp"

#include <algorithm>

namespace furrow::agents {

bool WorkLedger::accept(const WorkGrant& grant, const Order& order) {
  if (grant.epoch != order.epoch()) return false;
  std::erase_if(closures_, [&](const Closure& c) { return c.grant <= grant.closed_through; });
  if (grant.revision != order.revision()) return false;

  bool is_news = false;
  for (const GrantWindow& window : grant.windows) {
    if (window.id <= last_accepted_ || !order.is_open(window.cells)) continue;
    open_.push_back({window, 0});
    last_accepted_ = window.id;
    is_news = true;
  }
  return is_news;
}

std::uint32_t WorkLedger::licensed_to(std::uint32_t cell) const {
  // The rest of a window closed early comes under a newer id than the cells behind it.
  const auto begins_here = [&](const Open& o) { return o.window.cells.first + o.sprayed == cell; };
  for (;;) {
    const auto next = std::find_if(open_.begin(), open_.end(), begins_here);
    if (next == open_.end()) return cell;
    cell = end(next->window.cells);
  }
}

bool WorkLedger::spray(std::uint32_t cell, Instant at) {
  const auto open = std::find_if(open_.begin(), open_.end(), [&](const Open& o) {
    return o.window.cells.first + o.sprayed == cell;
  });
  require(open != open_.end(), "only granted cells are sprayed");
  sprayed_.insert(cell);
  if (++open->sprayed < open->window.cells.count) return false;
  close(*open, CloseReason::sprayed, at);
  open_.erase(open);
  return true;
}

bool WorkLedger::fits(const Order& order) const {
  return std::all_of(open_.begin(), open_.end(), [&](const Open& o) {
    const CellRange cells = o.window.cells;
    return order.is_open({cells.first + o.sprayed, cells.count - o.sprayed});
  });
}

void WorkLedger::close_all(CloseReason reason, Instant at) {
  for (const Open& open : open_) close(open, reason, at);
  open_.clear();
}

void WorkLedger::close_blocked(std::uint32_t cell, Instant at) {
  for (const Open& open : open_) {
    const bool is_at_hand = open.window.cells.first + open.sprayed == cell;
    close(open, is_at_hand ? CloseReason::blocked : CloseReason::superseded, at);
  }
  open_.clear();
}

void WorkLedger::close(const Open& open, CloseReason reason, Instant at) {
  closures_.push_back({.grant = open.window.id,
                       .cells = open.window.cells,
                       .sprayed = open.sprayed,
                       .reason = reason,
                       .at = at});
  last_closed_ = std::max(last_closed_, open.window.id);
}

}  // namespace furrow::agents
