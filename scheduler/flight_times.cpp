#include "scheduler/flight_times.hpp"

#include "core/require.hpp"

#include <algorithm>

namespace furrow::scheduler {
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
    : vehicle_{}, ferries_{route.ferries}, share_{{}, {}} {
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
  double detours_m = 0.0;
  for (std::uint32_t c = begin; c < end(problem.cells) && !route.detours.empty(); ++c) {
    detours_m += route.detours[c].longer_m;
    detours_s_.push_back(detours_m / vehicle_.spray_speed.base());
  }
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
            .to_its_end = planner::sprays_ends(strip),
            .leg = 0};
    for (std::uint32_t c = first; c < stop; ++c) {
      run.stops.push_back(planner::stop_point(route, strip, c));
    }
    runs_.push_back(std::move(run));
  }
  time_share();
}

// All of the share in one flight.
void FlightTimes::time_share() {
  Legs legs{runs_.front().begin};
  for (std::size_t r = 0; r < runs_.size(); ++r) {
    runs_[r].leg = legs.count();
    if (r + 1 < runs_.size()) lead_on(legs, r);
  }
  legs.add(runs_.back().stops.back(), vehicle_.spray_speed, Corner::stop);
  share_ = LegTimes{vehicle_, legs.all()};
}

bool FlightTimes::Run::has_length() const {
  return distance(begin, stops.back()).base() >= same_place_m;
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

// From within a run to the beginning of the next.
void FlightTimes::lead_on(Legs& legs, std::size_t r) const {
  const Run &run = runs_[r], &next = runs_[r + 1];
  const bool meets = distance(run.stops.back(), next.begin).base() < same_place_m;
  legs.add(run.stops.back(), vehicle_.spray_speed, run.corner(meets));
  if (!next.continues) {
    for (const FieldPoint at : next.approach) legs.add(at, vehicle_.ferry_speed, Corner::held);
  }
  legs.add(next.begin, next.continues || meets ? vehicle_.spray_speed : vehicle_.ferry_speed,
           run.corner(meets));
}

// From where it starts to where it takes up its work.
// @return  The run that it begins in.
std::size_t FlightTimes::begin(Legs& legs, const planner::PlannedSortie& sortie, bool is_first,
                               std::uint32_t from) const {
  auto run = std::partition_point(runs_.begin(), runs_.end(),
                                  [&](const Run& r) { return r.last < sortie.first; });
  // Work goes on from a cell sprayed before, unless a ferry follows it.
  const bool ferry_follows = !is_first && sortie.first == run->last && sortie.first < sortie.last &&
                             !std::next(run)->continues;
  if (ferry_follows) ++run;
  const bool begins_run = ferry_follows || (is_first && sortie.first <= run->first);
  const std::uint32_t cell = std::max(sortie.first, run->first);
  const FieldPoint entry = begins_run ? run->begin : run->stop(cell);
  Places way =
      begins_run ? way_out(is_first, from, run->first, run->begin) : way_home(from, cell, entry);
  if (!begins_run) std::reverse(way.begin(), way.end());
  for (const FieldPoint at : way) legs.add(at, vehicle_.ferry_speed, Corner::cut);
  legs.add(entry, vehicle_.ferry_speed, run->corner(false));
  return static_cast<std::size_t>(run - runs_.begin());
}

// From within a run to its `cell`.
void FlightTimes::finish(Legs& legs, std::size_t run, std::uint32_t cell, std::uint32_t to) const {
  for (const FieldPoint at : way_home(to, cell, runs_[run].stop(cell))) {
    legs.add(at, vehicle_.ferry_speed, Corner::cut);
  }
  legs.add(stands_[to].station, vehicle_.ferry_speed, Corner::stop);
}

SortieTimes FlightTimes::operator()(const planner::PlannedSortie& sortie, bool is_first,
                                    Ends ends) const {
  Legs legs{is_first ? vehicle_.home : stands_[ends.from].station};
  const std::size_t first = begin(legs, sortie, is_first, ends.from);
  const auto in = std::partition_point(runs_.begin(), runs_.end(),
                                       [&](const Run& r) { return r.last < sortie.last; });
  const std::size_t last = std::max(first, static_cast<std::size_t>(in - runs_.begin()));
  // Between the first whole run and the last, legs are those of the share.
  std::size_t head = first + 1, tail = last;
  while (head < tail && !runs_[head].has_length()) ++head;
  while (head < tail && (tail == last || !runs_[tail].has_length())) --tail;
  const auto lead = [&](Legs& on, std::size_t from, std::size_t to) {
    for (std::size_t r = from; r < to; ++r) lead_on(on, r);
  };
  const auto spray_last = [&](Legs& on) {
    on.add(runs_[last].stop(sortie.last), vehicle_.spray_speed, runs_[last].corner(false));
    const std::size_t sprayed = on.count();
    finish(on, last, sortie.last, ends.to);
    return sprayed;
  };
  SortieTimes times{};
  if (head < tail) {
    lead(legs, first, head);
    legs.add(share_.way()[runs_[head].leg]);
    Legs rest{runs_[tail].begin};
    lead(rest, tail, last);
    const std::size_t sprayed = spray_last(rest);
    times = share_.of(legs.all(), {runs_[head].leg, runs_[tail].leg}, rest.all(), sprayed);
  } else {
    lead(legs, first, last);
    const std::size_t sprayed = spray_last(legs);
    times = share_.of(legs.all(), sprayed);
  }
  if (!detours_s_.empty()) {  // a later sortie begins after its first cell
    times.until_sprayed_s += detours_s_[sortie.last] - (is_first ? 0.0 : detours_s_[sortie.first]);
  }
  if (!late_s_.empty()) {
    times.until_sprayed_s += stands_[ends.from].late_out_s[sortie.first] +
                             (late_s_[sortie.last] - resume_late_s_[sortie.first]);
    times.home_s += stands_[ends.to].late_back_s[sortie.last];
  }
  return times;
}

}  // namespace furrow::scheduler
