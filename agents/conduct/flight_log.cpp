#include "agents/conduct/flight_log.hpp"

#include "agents/guidance/deviation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace furrow::agents {
namespace {

constexpr double bend_m = 0.03, height_m = 0.1;

// Whether a way straight and even from the first of `passed` to a height would leave out heights.
bool cuts_top(const std::vector<TrackPoint>& passed, Instant at, double altitude_m) {
  if (passed.size() < 2) return false;
  const TrackPoint& from = passed.front();
  return std::any_of(passed.begin() + 1, passed.end(), [&](const TrackPoint& p) {
    const double share = seconds(p.at - from.at) / seconds(at - from.at);
    return std::abs(std::lerp(from.altitude_m, altitude_m, share) - p.altitude_m) > height_m;
  });
}

// Whether the straight line from the first of `passed` to `ahead_m` leaves out the way between.
bool cuts_corner(const std::vector<TrackPoint>& passed, Xy ahead_m) {
  if (passed.size() < 2) return false;
  const Xy from_m = xy_m(passed.front().position);
  const bool is_still = norm(ahead_m - from_m) == 0;
  return std::any_of(passed.begin() + 1, passed.end(), [&](const TrackPoint& p) {
    const Xy place_m = xy_m(p.position);
    const double away_m =
        is_still ? norm(place_m - from_m) : std::abs(cross_track_m(from_m, ahead_m, place_m));
    return away_m > bend_m;
  });
}

double offset_m(const Piece& strip, Xy place_m) {
  // A piece of one cell runs in the direction in which it is entered.
  const bool is_one = strip.from == strip.to;
  if (is_one && !(strip.exit == strip.to)) {
    return cross_track_m(xy_m(strip.entry), xy_m(strip.exit), place_m);
  }
  const FieldPoint behind = is_one ? strip.entry : strip.from;
  return cross_track_m(xy_m(behind), xy_m(strip.to), place_m);
}

void add(FlightRecord::Deviation& sum, double cross_m) {
  ++sum.samples;
  sum.sum_squares += cross_m * cross_m;
  sum.largest = std::max(sum.largest, std::abs(cross_m));
}

}  // namespace

void FlightLog::point(Instant at, Xy truth_m, double altitude_m, bool is_spraying, Length width) {
  keep_bend(at, truth_m, altitude_m);
  keep({.at = at,
        .position = field_point(truth_m),
        .spraying = is_spraying,
        .altitude_m = altitude_m,
        .width = width});
}

void FlightLog::pass(Instant at, Xy truth_m, double altitude_m, bool is_spraying, Length width) {
  keep_bend(at, truth_m, altitude_m);
  passed_.push_back({.at = at,
                     .position = field_point(truth_m),
                     .spraying = is_spraying,
                     .altitude_m = altitude_m,
                     .width = width});
}

void FlightLog::keep_bend(Instant at, Xy ahead_m, double altitude_m) {
  const bool is_bend = cuts_corner(passed_, ahead_m) || cuts_top(passed_, at, altitude_m);
  if (is_bend) keep(TrackPoint{passed_.back()});
}

void FlightLog::keep(const TrackPoint& point) {
  if (!record_.track.empty() && record_.track.back().at == point.at) record_.track.pop_back();
  record_.track.push_back(point);
  passed_ = {point};
}

void FlightLog::sample(const Piece& strip, const Aircraft& aircraft) {
  add(record_.truth, offset_m(strip, aircraft.truth_m()));
  add(record_.fix, offset_m(strip, aircraft.fix_m()));
}

void FlightLog::cell(std::uint32_t cell, const Piece& strip, const Aircraft& aircraft) {
  if (record_.cells.count == 0) record_.cells.first = cell;
  ++record_.cells.count;
  record_.offsets_m.push_back(static_cast<float>(offset_m(strip, aircraft.truth_m())));
}

FlightRecord FlightLog::take() {
  FlightRecord fresh{};
  fresh.agent = record_.agent;
  return std::exchange(record_, std::move(fresh));
}

}  // namespace furrow::agents
