#include "scheduler/ledger.hpp"

#include "core/require.hpp"

#include <algorithm>

namespace furrow::scheduler {

std::uint32_t& Ledger::count(CellState state) {
  switch (state) {
    case CellState::open: return counts_.open;
    case CellState::granted: return counts_.granted;
    case CellState::sprayed: return counts_.sprayed;
    case CellState::abandoned: return counts_.abandoned;
    case CellState::uncertain: break;
  }
  return counts_.uncertain;
}

void Ledger::set(CellRange cells, CellState state) {
  for (std::uint32_t c = cells.first; c < end(cells); ++c) {
    --count(cells_[c]);
    ++count(state);
    cells_[c] = state;
  }
}

GrantWindow Ledger::grant(AgentId agent, CellRange cells) {
  const auto open = first_open(cells);
  require(cells.count > 0 && open && *open == cells, "only open cells are granted");
  Account& account = accounts_[agent];
  set(cells, CellState::granted);
  account.open.emplace(++account.last_granted, cells);
  return {account.last_granted, cells};
}

Booking Ledger::book(AgentId agent, const Closure& closure) {
  const auto found = accounts_.find(agent);
  if (found == accounts_.end()) return Booking::refused;
  Account& account = found->second;
  const auto window = account.open.find(closure.grant);
  if (window == account.open.end()) {
    const bool was_granted = closure.grant > 0 && closure.grant <= account.last_granted;
    return was_granted ? Booking::known : Booking::refused;
  }
  const CellRange cells = window->second;
  const bool is_whole = closure.sprayed == cells.count;
  if (closure.cells != cells || closure.sprayed > cells.count ||
      (closure.reason == CloseReason::sprayed && !is_whole)) {
    return Booking::refused;
  }
  set({cells.first, closure.sprayed}, CellState::sprayed);
  set({cells.first + closure.sprayed, cells.count - closure.sprayed}, CellState::open);
  account.last_booked = std::max(account.last_booked, closure.grant);
  account.open.erase(window);
  return Booking::booked;
}

std::vector<CellRange> Ledger::abandon(CellRange range) {
  std::vector<CellRange> given_up;
  for (auto open = first_open(range); open; open = first_open(range)) {
    set(*open, CellState::abandoned);
    given_up.push_back(*open);
  }
  return given_up;
}

std::vector<CellRange> Ledger::forsake(AgentId agent) {
  std::vector<CellRange> given_up;
  for (const auto& [id, cells] : accounts_[agent].open) {
    set(cells, CellState::uncertain);
    given_up.push_back(cells);
  }
  accounts_[agent].open.clear();
  return given_up;
}

std::optional<CellRange> Ledger::first_open(CellRange range) const {
  require(end(range) <= cells_.size(), "a range of cells lies within the route");
  const auto from = cells_.begin() + range.first;
  const auto to = from + range.count;
  const auto first = std::find(from, to, CellState::open);
  if (first == to) return std::nullopt;
  const auto last = std::find_if(first, to, [](CellState s) { return s != CellState::open; });
  return CellRange{static_cast<std::uint32_t>(first - cells_.begin()),
                   static_cast<std::uint32_t>(last - first)};
}

std::vector<GrantWindow> Ledger::windows(AgentId agent) const {
  std::vector<GrantWindow> open;
  const auto account = accounts_.find(agent);
  if (account == accounts_.end()) return open;
  for (const auto& [id, cells] : account->second.open) open.push_back({id, cells});
  return open;
}

std::uint64_t Ledger::closed_through(AgentId agent) const {
  const auto account = accounts_.find(agent);
  if (account == accounts_.end()) return 0;
  const auto& open = account->second.open;
  return open.empty() ? account->second.last_granted : open.begin()->first - 1;
}

std::uint64_t Ledger::last_granted(AgentId agent) const {
  const auto account = accounts_.find(agent);
  return account == accounts_.end() ? 0 : account->second.last_granted;
}

std::uint64_t Ledger::last_booked(AgentId agent) const {
  const auto account = accounts_.find(agent);
  return account == accounts_.end() ? 0 : account->second.last_booked;
}

}  // namespace furrow::scheduler
