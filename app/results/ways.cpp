#include "app/results/ways.hpp"

#include "planner/coverage/swath/swath.hpp"
#include "scheduler/orders.hpp"

#include <algorithm>

namespace furrow::app {
namespace {

Way way_at_work(const SortieOrder& sortie) {
  Way way;
  for (const Piece& piece : sortie.pieces) {
    if (!way.empty()) way.insert(way.end(), piece.approach.begin(), piece.approach.end());
    // From the cell before, a strip of cells is entered askew.
    way.insert(way.end(), {piece.entry, piece.from, piece.exit});
  }
  return way;
}

// The points of one sortie's track, with the part of it during which it was at work.
class SortieTrack {
 public:
  void add(const TrackPoint& point) {
    const bool was_open = is_open_;
    is_open_ = point.spraying;
    whole_.push_back(point.position);
    if (is_open_ && begin_ == none) begin_ = whole_.size() - 1;
    if (was_open || is_open_) end_ = whole_.size();
  }

  /// Of a survey, where the valve stays closed: from the place nearest to `first` to that nearest
  /// to `last`.
  void work_between(FieldPoint first, FieldPoint last) {
    if (whole_.empty()) return;
    const auto nearest = [&](auto from, FieldPoint to) {
      return std::min_element(from, whole_.end(), [&](FieldPoint a, FieldPoint b) {
        return distance(a, to) < distance(b, to);
      });
    };
    const auto begin = nearest(whole_.begin(), first);
    begin_ = static_cast<std::size_t>(begin - whole_.begin());
    end_ = static_cast<std::size_t>(nearest(begin, last) - whole_.begin()) + 1;
  }

  void end(MissionWays& ways) {
    if (begin_ != none) {
      ways.at_work.emplace_back(whole_.begin() + static_cast<std::ptrdiff_t>(begin_),
                                whole_.begin() + static_cast<std::ptrdiff_t>(end_));
    }
    if (!whole_.empty()) ways.whole.push_back(std::move(whole_));
    *this = {};
  }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  Way whole_{};
  std::size_t begin_ = none, end_ = 0;
  bool is_open_ = false;
};

}  // namespace

MissionWays planned_ways(const planner::Route& route, const scheduler::UavPlan& uav) {
  MissionWays ways;
  FieldPoint from = uav.vehicle.home;
  std::size_t sorties = 0;
  for (const SortieOrder& sortie : scheduler::orders(route, uav)) {
    const Way way = way_at_work(sortie);
    ways.at_work.push_back(way);
    Way whole = route.ferries.ferry_way(from, way.front(), uav.vehicle);
    whole.insert(whole.end(), way.begin() + 1, way.end());
    from = scheduler::landing(uav, sorties++).position;
    const Way home = route.ferries.ferry_way(way.back(), from, uav.vehicle);
    whole.insert(whole.end(), home.begin() + 1, home.end());
    ways.whole.push_back(std::move(whole));
  }
  return ways;
}

MissionWays flown_ways(const FlownUav& uav, bool is_survey) {
  MissionWays ways;
  auto sortie = uav.sorties.begin();
  SortieTrack track;
  const auto end = [&] {
    if (is_survey && sortie != uav.sorties.end()) {
      track.work_between(sortie->resumed_at, sortie->returned_at);
    }
    track.end(ways);
  };
  for (const TrackPoint& point : uav.track) {
    while (sortie != uav.sorties.end() && sortie->landed < point.at) {
      end();
      ++sortie;
    }
    track.add(point);
  }
  end();
  return ways;
}

MissionWays together(const std::vector<MissionWays>& by_uav) {
  MissionWays all;
  for (const MissionWays& ways : by_uav) {
    all.whole.insert(all.whole.end(), ways.whole.begin(), ways.whole.end());
    all.at_work.insert(all.at_work.end(), ways.at_work.begin(), ways.at_work.end());
  }
  return all;
}

double length_m(const std::vector<Way>& ways) {
  double sum_m = 0;
  for (const Way& way : ways) sum_m += way_length(way).base();
  return sum_m;
}

double ferry_m(const MissionWays& ways) { return length_m(ways.whole) - length_m(ways.at_work); }

double outside_m(const MissionRecord& record, const std::vector<Way>& ways) {
  const auto outside = planner::length_outside(record.scenario.field, ways, edge_tolerance);
  return outside ? outside->base() : 0;  // the plan has judged the field
}

}  // namespace furrow::app
