#include "scheduler/flight_times.hpp"

#include "core/corner.hpp"
#include "core/require.hpp"

#include <algorithm>
#include <cmath>

namespace furrow::scheduler {
namespace {

constexpr double turning_share = 0.9;  // of the acceleration: the rest keeps aircraft on their arcs
constexpr double same_place_m = 1e-6;

/// Straight legs from rest to rest, to be timed. Metres and seconds.
class Way {
 public:
  Way(FieldPoint start, const Vehicle& vehicle)
      : acceleration_{planned_acceleration(vehicle).base()},
        cut_m_{0.5 * vehicle.swath.base()},
        min_radius_m_{vehicle.min_turn_radius.base()},
        at_{start} {}

  void add(FieldPoint to, Speed limit, Corner corner) {
    const double length_m = distance(at_, to).base();
    if (length_m < same_place_m) {
      if (!legs_.empty()) legs_.back().corner = std::max(legs_.back().corner, corner);
      return;
    }
    legs_.push_back({.x = (to - at_).x.base() / length_m,
                     .y = (to - at_).y.base() / length_m,
                     .length_m = length_m,
                     .limit_mps = limit.base(),
                     .corner = corner});
    at_ = to;
  }

  std::size_t legs() const { return legs_.size(); }

  /// @param sprayed_legs  After so many legs the last cell is sprayed: in the middle of an arc.
  SortieTimes times(std::size_t sprayed_legs);

 private:
  struct Leg {
    double x, y;  // unit vector
    double length_m, limit_mps;
    Corner corner;  // where it ends
  };
  struct Stretch {
    double length_m, limit_mps, entry_mps;
  };

  double lay_corner(const Leg& in, const Leg& out);
  void plan_speeds();
  double flown_s(const Stretch& stretch, double entry_mps, double exit_mps) const;

  double acceleration_, cut_m_, min_radius_m_;
  FieldPoint at_;
  std::vector<Leg> legs_{};
  std::vector<Stretch> stretches_{};  ///< Each leg's straight, then its corner.
};

/// Appends the corner between two legs.
/// @return  How much of each leg it takes [m].
double Way::lay_corner(const Leg& in, const Leg& out) {
  const double angle =
      std::abs(std::atan2(in.x * out.y - in.y * out.x, in.x * out.x + in.y * out.y));
  if (angle <= straight_rad) {
    stretches_.push_back({0.0, std::min(in.limit_mps, out.limit_mps), 0.0});
    return 0.0;
  }
  const auto [cut_m, radius_m] =
      corner_arc(in.corner, angle, std::min(in.length_m, out.length_m), cut_m_, min_radius_m_);
  if (radius_m == 0.0) {
    stretches_.push_back({0.0, 0.0, 0.0});
    return 0.0;
  }
  const double turning_mps = std::sqrt(turning_share * acceleration_ * radius_m);
  stretches_.push_back(
      {radius_m * angle, std::min({in.limit_mps, out.limit_mps, turning_mps}), 0.0});
  return cut_m;
}

void Way::plan_speeds() {
  double exit_mps = 0.0;
  for (std::size_t i = stretches_.size(); i-- > 0;) {
    Stretch& s = stretches_[i];
    s.entry_mps =
        std::min(s.limit_mps, std::sqrt(exit_mps * exit_mps + 2.0 * acceleration_ * s.length_m));
    if (i > 0) s.entry_mps = std::min(s.entry_mps, stretches_[i - 1].limit_mps);
    exit_mps = s.entry_mps;
  }
}

double Way::flown_s(const Stretch& stretch, double entry_mps, double exit_mps) const {
  if (stretch.length_m <= 0.0) return 0.0;
  const double squares = entry_mps * entry_mps + exit_mps * exit_mps;
  const double reached_mps = std::sqrt(acceleration_ * stretch.length_m + 0.5 * squares);
  const double peak_mps = std::max({std::min(reached_mps, stretch.limit_mps), entry_mps, exit_mps});
  const double ramps_m = (2.0 * peak_mps * peak_mps - squares) / (2.0 * acceleration_);
  return (2.0 * peak_mps - entry_mps - exit_mps) / acceleration_ +
         std::max(0.0, stretch.length_m - ramps_m) / peak_mps;
}

SortieTimes Way::times(std::size_t sprayed_legs) {
  double taken_m = 0.0;  // of the leg, by the corner before it
  for (std::size_t i = 0; i < legs_.size(); ++i) {
    const std::size_t straight = stretches_.size();
    stretches_.push_back({0.0, legs_[i].limit_mps, 0.0});
    const double cut_m = i + 1 < legs_.size() ? lay_corner(legs_[i], legs_[i + 1]) : 0.0;
    stretches_[straight].length_m = std::max(0.0, legs_[i].length_m - taken_m - cut_m);
    taken_m = cut_m;
  }
  plan_speeds();

  double sum_s = 0.0, sprayed_s = 0.0, entry_mps = 0.0;
  for (std::size_t i = 0; i < stretches_.size(); ++i) {
    const Stretch& s = stretches_[i];
    const double wanted_mps = i + 1 < stretches_.size() ? stretches_[i + 1].entry_mps : 0.0;
    const double exit_mps =
        std::min(wanted_mps, std::sqrt(entry_mps * entry_mps + 2.0 * acceleration_ * s.length_m));
    const double took_s = flown_s(s, entry_mps, exit_mps);
    // Stretches 2 i and 2 i + 1 are leg i and the corner after it.
    if (i + 1 == 2 * sprayed_legs) sprayed_s = sum_s + 0.5 * took_s;
    sum_s += took_s;
    if (i + 2 == 2 * sprayed_legs && i + 1 == stretches_.size()) sprayed_s = sum_s;
    entry_mps = exit_mps;
  }
  return {.until_sprayed_s = sprayed_s, .home_s = sum_s - sprayed_s};
}

}  // namespace

FlightTimes::FlightTimes(const planner::Route& route, const planner::ReturnProblem& problem)
    : FlightTimes{route, std::vector<const planner::ReturnProblem*>{&problem}} {}

void FlightTimes::add_stand(const planner::ReturnProblem& problem) {
  Stand stand{.station = problem.station.position, .back_m = problem.back_m};
  if (problem.hills) {
    const double ferry_mps = problem.vehicle.ferry_speed.base();
    for (std::uint32_t i = 0; i < problem.cells.count; ++i) {
      stand.late_back_s.push_back(problem.back_s(i) - problem.back_m[i] / ferry_mps);
      stand.late_out_s.push_back(problem.out_s(i) - problem.out_m[i] / ferry_mps);
    }
  }
  stands_.push_back(std::move(stand));
}

FlightTimes::FlightTimes(const planner::Route& route,
                         std::span<const planner::ReturnProblem* const> problems)
    : vehicle_{}, ferries_{route.ferries} {
  const planner::ReturnProblem* known = nullptr;
  for (const planner::ReturnProblem* p : problems) {
    if (p == nullptr) {
      stands_.emplace_back();
      continue;
    }
    known = p;
    add_stand(*p);
  }
  require(known != nullptr, "sorties end somewhere");
  const planner::ReturnProblem& problem = *known;
  vehicle_ = problem.vehicle;
  if (problem.hills) {
    late_s_ = problem.hills->late_s;
    resume_late_s_ = problem.hills->resume_late_s;
  }
  const std::uint32_t begin = problem.cells.first;
  for (const planner::Strip& strip : route.strips) {
    const std::uint32_t first = std::max(strip.cells.first, begin);
    const std::uint32_t stop = std::min(end(strip.cells), end(problem.cells));
    if (first >= stop) continue;
    Run run{.first = first - begin,
            .last = stop - 1 - begin,
            .begin = planner::start_point(route, strip, first),
            .stops = {},
            .approach = strip.approach,
            .continues = strip.continues,
            .to_its_end = planner::sprays_ends(strip)};
    for (std::uint32_t c = first; c < stop; ++c) {
      run.stops.push_back(planner::stop_point(route, strip, c));
    }
    runs_.push_back(std::move(run));
  }
}

// Between the stop of a cell and the station, both left out; empty where it is straight.
const FlightTimes::Places& FlightTimes::way_home(std::uint32_t stand, std::uint32_t cell,
                                                 FieldPoint stop) const {
  static const Places straight;
  const auto& [station, back_m, late_back_s, late_out_s] = stands_[stand];
  if (back_m[cell] <= distance(stop, station).base() + same_place_m) return straight;
  const auto [known, is_new] = ways_home_.try_emplace({stand, cell});
  if (is_new) {
    const Places way = ferries_.ferry_way(stop, station, vehicle_);
    known->second.assign(way.begin() + 1, way.end() - 1);
  }
  return known->second;
}

// To the beginning of the run that starts with `cell`, both ends left out.
const FlightTimes::Places& FlightTimes::way_out(bool is_first, std::uint32_t stand,
                                                std::uint32_t cell, FieldPoint begin) const {
  const auto [known, is_new] = ways_out_.try_emplace({is_first, is_first ? 0 : stand, cell});
  if (is_new) {
    const FieldPoint from = is_first ? vehicle_.home : stands_[stand].station;
    const Places way = ferries_.ferry_way(from, begin, vehicle_);
    known->second.assign(way.begin() + 1, way.end() - 1);
  }
  return known->second;
}

SortieTimes FlightTimes::operator()(const planner::PlannedSortie& sortie, bool is_first,
                                    Ends ends) const {
  auto run = std::partition_point(runs_.begin(), runs_.end(),
                                  [&](const Run& r) { return r.last < sortie.first; });
  // Work goes on from a cell sprayed before, unless a ferry follows it.
  const bool ferry_follows = !is_first && sortie.first == run->last && sortie.first < sortie.last &&
                             !std::next(run)->continues;
  if (ferry_follows) ++run;
  const bool begins_run = ferry_follows || (is_first && sortie.first <= run->first);
  const auto corner = [&](bool open) {
    return !run->to_its_end ? Corner::cut : open ? Corner::held : Corner::stop;
  };
  Way way{is_first ? vehicle_.home : stands_[ends.from].station, vehicle_};
  if (begins_run) {
    for (const FieldPoint at : way_out(is_first, ends.from, run->first, run->begin)) {
      way.add(at, vehicle_.ferry_speed, Corner::cut);
    }
    way.add(run->begin, vehicle_.ferry_speed, corner(false));
  } else {
    const std::uint32_t cell = std::max(sortie.first, run->first);
    const Places& home = way_home(ends.from, cell, run->stop(cell));
    for (auto at = home.rbegin(); at != home.rend(); ++at) {
      way.add(*at, vehicle_.ferry_speed, Corner::cut);
    }
    way.add(run->stop(cell), vehicle_.ferry_speed, corner(false));
  }
  while (run->last < sortie.last) {
    const Run& next = *std::next(run);
    const bool meets = distance(run->stops.back(), next.begin).base() < same_place_m;
    way.add(run->stops.back(), vehicle_.spray_speed, corner(meets));
    if (!next.continues) {
      for (const FieldPoint at : next.approach) way.add(at, vehicle_.ferry_speed, Corner::held);
    }
    way.add(next.begin, next.continues || meets ? vehicle_.spray_speed : vehicle_.ferry_speed,
            corner(meets));
    ++run;
  }
  way.add(run->stop(sortie.last), vehicle_.spray_speed, corner(false));
  const std::size_t sprayed_legs = way.legs();
  for (const FieldPoint at : way_home(ends.to, sortie.last, run->stop(sortie.last))) {
    way.add(at, vehicle_.ferry_speed, Corner::cut);
  }
  way.add(stands_[ends.to].station, vehicle_.ferry_speed, Corner::stop);
  SortieTimes times = way.times(sprayed_legs);
  if (!late_s_.empty()) {
    times.until_sprayed_s += stands_[ends.from].late_out_s[sortie.first] +
                             (late_s_[sortie.last] - resume_late_s_[sortie.first]);
    times.home_s += stands_[ends.to].late_back_s[sortie.last];
  }
  return times;
}

}  // namespace furrow::scheduler
