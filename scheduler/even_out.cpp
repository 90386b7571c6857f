#include "scheduler/even_out.hpp"

#include "core/require.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace furrow::scheduler {
namespace {

constexpr std::uint32_t least_cells = 2;  // of a sortie

/// A sortie of the lists.
struct Place {
  std::size_t uav, sortie;
};

/// Cells from a sortie to the one that it meets at one of its ends.
struct Move {
  Place from, to;
  bool at_begin;  ///< Of `from`; it meets the end of `to` there.
  std::uint32_t cells;
};

struct Moved {
  std::vector<CellSortie> from, to;
  Itinerary from_flies, to_flies;
  std::tuple<double, double> worth;
};

class Fleet {
 public:
  Fleet(const planner::Route& route, const RouteLengths& lengths, std::span<const Vehicle> vehicles,
        std::span<const Station> stations, SortieLists lists, std::span<const double> ready_s)
      : route_{route},
        lengths_{lengths},
        vehicles_{vehicles},
        stations_{stations},
        lists_{std::move(lists)},
        ready_s_{ready_s} {
    for (std::size_t u = 0; u < vehicles.size(); ++u) {
      auto flown = itinerary_of(u, lists_[u]);
      require(flown.has_value(), "the lists are carried");
      itineraries_.push_back(std::move(*flown));
    }
    foresee();
  }

  /// Makes the best of the moves from whoever is done last.
  /// @param left  Moves that may be tried.
  /// @return  Whether one is worth it.
  bool improve(std::uint64_t& left) {
    std::optional<std::pair<Move, Moved>> best;
    for (const Move& move : moves()) {
      if (left == 0) break;
      --left;
      auto moved = tried(move);
      if (!moved || moved->worth >= (best ? best->second.worth : worth_)) continue;
      best.emplace(move, std::move(*moved));
    }
    if (!best) return false;
    auto& [move, moved] = *best;
    lists_[move.from.uav] = std::move(moved.from);
    lists_[move.to.uav] = std::move(moved.to);
    itineraries_[move.from.uav] = std::move(moved.from_flies);
    itineraries_[move.to.uav] = std::move(moved.to_flies);
    foresee();
    return true;
  }

  SortieLists lists() && { return std::move(lists_); }

 private:
  std::optional<Itinerary> itinerary_of(std::size_t uav,
                                        const std::vector<CellSortie>& list) const {
    if (list.empty()) return grounded(vehicles_[uav].id);
    const std::span<const double> ready = ready_s_.empty() ? ready_s_ : ready_s_.subspan(uav, 1);
    auto flown = flown_lists(route_, lengths_, vehicles_.subspan(uav, 1), stations_, {list}, ready);
    if (!flown || !flown->forecast.is_sure) return std::nullopt;
    return std::move(flown->itineraries.front());
  }

  void foresee() {
    Forecast all = forecast(itineraries_, stations_);
    worth_ = worth(all);
    ends_s_ = std::move(all.spray_ends_s);
  }

  std::vector<Place> along() const {
    std::vector<Place> places;
    for (std::size_t u = 0; u < lists_.size(); ++u) {
      for (std::size_t k = 0; k < lists_[u].size(); ++k) places.push_back({u, k});
    }
    std::sort(places.begin(), places.end(),
              [&](Place a, Place b) { return at(a).cells.first < at(b).cells.first; });
    return places;
  }
  const CellSortie& at(Place p) const { return lists_[p.uav][p.sortie]; }

  std::vector<Move> moves() const {
    const auto last = static_cast<std::size_t>(std::max_element(ends_s_.begin(), ends_s_.end()) -
                                               ends_s_.begin());
    std::vector<Move> made;
    const std::vector<Place> places = along();
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (places[i].uav != last) continue;
      if (i > 0) add(places[i], places[i - 1], true, made);
      if (i + 1 < places.size()) add(places[i], places[i + 1], false, made);
    }
    return made;
  }

  // By half the time between the two, and by less.
  void add(Place from, Place to, bool at_begin, std::vector<Move>& made) const {
    const double apart_s = ends_s_[from.uav] - ends_s_[to.uav];
    if (from.uav == to.uav || apart_s <= 0) return;
    const Vehicle& v = vehicles_[to.uav];
    const std::uint32_t all = at(from).cells.count;
    const double half = 0.5 * apart_s * (v.spray_speed / v.swath).base();
    const auto most = static_cast<std::uint32_t>(std::clamp(half, 1.0, static_cast<double>(all)));
    std::uint32_t before = 0;
    for (std::uint32_t cells : {most, (most + 2) / 3, 1U}) {
      if (all - cells < least_cells) cells = all;
      if (cells != before) made.push_back({from, to, at_begin, cells});
      before = cells;
    }
  }

  std::optional<Moved> tried(const Move& move) const {
    Moved moved{.from = lists_[move.from.uav],
                .to = lists_[move.to.uav],
                .from_flies = {},
                .to_flies = {},
                .worth = {}};
    CellRange& gives = moved.from[move.from.sortie].cells;
    CellRange& takes = moved.to[move.to.sortie].cells;
    gives.count -= move.cells;
    takes.count += move.cells;
    if (move.at_begin) {
      gives.first += move.cells;
    } else {
      takes.first -= move.cells;
    }
    if (gives.count == 0) {
      moved.from.erase(moved.from.begin() + static_cast<std::ptrdiff_t>(move.from.sortie));
    }
    auto from = itinerary_of(move.from.uav, moved.from);
    auto to = itinerary_of(move.to.uav, moved.to);
    if (!from || !to) return std::nullopt;
    std::vector<Itinerary> all = itineraries_;
    all[move.from.uav] = moved.from_flies = std::move(*from);
    all[move.to.uav] = moved.to_flies = std::move(*to);
    const Forecast foreseen = forecast(all, stations_);
    if (!is_in_time(vehicles_, foreseen)) return std::nullopt;
    moved.worth = scheduler::worth(foreseen);
    return moved;
  }

  const planner::Route& route_;
  const RouteLengths& lengths_;
  std::span<const Vehicle> vehicles_;
  std::span<const Station> stations_;
  SortieLists lists_;
  std::span<const double> ready_s_;
  std::vector<Itinerary> itineraries_{};
  std::vector<double> ends_s_{};
  std::tuple<double, double> worth_{};
};

}  // namespace

SortieLists evened_out(const planner::Route& route, const RouteLengths& lengths,
                       std::span<const Vehicle> vehicles, std::span<const Station> stations,
                       SortieLists lists, std::span<const double> ready_s, std::uint64_t most) {
  Fleet fleet{route, lengths, vehicles, stations, std::move(lists), ready_s};
  while (most > 0 && fleet.improve(most)) {
  }
  return std::move(fleet).lists();
}

}  // namespace furrow::scheduler
