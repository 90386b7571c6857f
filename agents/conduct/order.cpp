#include "agents/conduct/order.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace furrow::agents {
namespace {

FieldPoint cell_center(const Piece& p, std::uint32_t index) {
  const double share = p.cells.count < 2 ? 0.0 : static_cast<double>(index) / (p.cells.count - 1);
  return p.from + FieldVector{share * (p.to - p.from).x, share * (p.to - p.from).y};
}

bool is_finite(FieldPoint p) { return std::isfinite(p.x.base()) && std::isfinite(p.y.base()); }

std::optional<std::string> fault_in(const Piece& p) {
  const std::string name = "piece at cell " + std::to_string(p.cells.first);
  if (p.cells.count == 0) return name + " has no cells";
  if (end(p.cells) < p.cells.first) return name + " counts past the last cell there can be";
  if (!is_finite(p.entry) || !is_finite(p.from) || !is_finite(p.to) || !is_finite(p.exit) ||
      !std::all_of(p.approach.begin(), p.approach.end(), is_finite)) {
    return name + " is nowhere";
  }
  if (!p.approach_altitudes_m.empty() && p.approach_altitudes_m.size() != p.approach.size()) {
    return name + " has " + std::to_string(p.approach_altitudes_m.size()) + " heights for " +
           std::to_string(p.approach.size()) + " way points";
  }
  if (!std::isfinite(p.width.base()) || p.width < Length{}) {
    return name + " is " + std::to_string(p.width.base()) + " m wide";
  }
  if ((p.cells.count == 1) != (p.from == p.to)) {
    return name + " has " + std::to_string(p.cells.count) + " cells on " +
           std::to_string(distance(p.from, p.to).base()) + " m";
  }
  return std::nullopt;
}

// A cell sprayed already that `order` comes to after others.
std::optional<std::string> sprayed_late(Order order, const std::set<std::uint32_t>& sprayed) {
  if (sprayed.empty()) return std::nullopt;
  for (; !order.is_finished(); order.spray()) {
    if (!sprayed.contains(order.next_cell())) continue;
    return "cell " + std::to_string(order.next_cell()) + " is sprayed already";
  }
  return std::nullopt;
}

}  // namespace

Order::Order(Command command, const std::set<std::uint32_t>& sprayed) : Order{std::move(command)} {
  while (!is_finished() && sprayed.contains(next_cell())) spray();
}

bool Order::is_older_than(const Command& c) const {
  return std::tuple{epoch(), revision()} < std::tuple{c.epoch, c.revision};
}

bool Order::is_same_as(const Command& c) const {
  return epoch() == c.epoch && revision() == c.revision;
}

std::uint32_t Order::next_cell() const {
  return command_.sorties[sortie_].pieces[piece_].cells.first + in_piece_;
}

std::vector<Piece> Order::rest_of_sortie() const {
  const auto& pieces = command_.sorties[sortie_].pieces;
  std::vector<Piece> rest(pieces.begin() + static_cast<std::ptrdiff_t>(piece_), pieces.end());
  if (in_piece_ > 0) {
    Piece& cut = rest.front();
    cut.entry = cell_center(cut, in_piece_ - 1);
    cut.from = cell_center(cut, in_piece_);
    cut.approach.clear();
    cut.approach_altitudes_m.clear();
    cut.cells = {cut.cells.first + in_piece_, cut.cells.count - in_piece_};
  }
  return rest;
}

bool Order::spray() {
  const auto& pieces = command_.sorties[sortie_].pieces;
  if (++in_piece_ < pieces[piece_].cells.count) return false;
  in_piece_ = 0;
  if (++piece_ < pieces.size()) return false;
  piece_ = 0;
  ++sortie_;
  return true;
}

bool Order::goes_on_as(const Order& other) const {
  return station() == other.station() && rest_of_sortie() == other.rest_of_sortie();
}

bool Order::is_open(CellRange cells) const {
  if (is_finished() || cells.count == 0) return false;
  for (std::size_t s = sortie_; s < command_.sorties.size(); ++s) {
    const auto& pieces = command_.sorties[s].pieces;
    for (std::size_t p = s == sortie_ ? piece_ : 0; p < pieces.size(); ++p) {
      const bool is_current = s == sortie_ && p == piece_;
      const std::uint32_t first = is_current ? next_cell() : pieces[p].cells.first;
      const std::uint32_t stop = end(pieces[p].cells);
      if (cells.first >= first && cells.first < stop) return cells.count <= stop - cells.first;
    }
  }
  return false;
}

std::optional<std::string> fault_in(const Command& command, std::span<const Station> stations,
                                    const std::set<std::uint32_t>& sprayed) {
  std::vector<CellRange> ordered;
  for (const SortieOrder& sortie : command.sorties) {
    const bool is_known = std::any_of(stations.begin(), stations.end(),
                                      [&](const Station& s) { return s.id == sortie.station; });
    if (!is_known) return "station " + std::to_string(number(sortie.station)) + " is unknown";
    if (sortie.pieces.empty()) return "a sortie without pieces";
    for (const Piece& piece : sortie.pieces) {
      if (auto fault = fault_in(piece)) return fault;
      ordered.push_back(piece.cells);
    }
  }
  std::sort(ordered.begin(), ordered.end(),
            [](CellRange a, CellRange b) { return a.first < b.first; });
  for (std::size_t i = 1; i < ordered.size(); ++i) {
    if (ordered[i].first >= end(ordered[i - 1])) continue;
    return "cell " + std::to_string(ordered[i].first) + " is ordered twice";
  }
  return sprayed_late(Order{command, sprayed}, sprayed);
}

}  // namespace furrow::agents
