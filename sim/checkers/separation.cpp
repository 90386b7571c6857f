#include "sim/checkers/separation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace furrow::sim {
namespace {

constexpr Duration one_second{1'000'000'000};
constexpr Duration hair{1'000'000};  // encounters that near in time are one

using Place = std::array<double, 3>;  // [m]

Place place(const TrackPoint& p) {
  return {p.position.x.base(), p.position.y.base(), p.altitude_m};
}

struct Leg {
  std::size_t track;
  Instant from, to;
  Place begin, end;

  double west_m() const { return std::min(begin[0], end[0]); }
  double east_m() const { return std::max(begin[0], end[0]); }
  Place at(Instant t) const {
    const double share = seconds(t - from) / seconds(to - from);
    Place p{};
    for (std::size_t i = 0; i < 3; ++i) p[i] = begin[i] + share * (end[i] - begin[i]);
    return p;
  }
};

struct Nearness {
  Instant from, to;
  double closest_m;
};

using Meetings = std::map<std::pair<std::size_t, std::size_t>, std::vector<Nearness>>;

double dot(const Place& a, const Place& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Place minus(const Place& a, const Place& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

// When two aircraft on straight legs are nearer than `distance_m`: where |r + s v| is less, for
// the share s of the time that both legs have in common.
std::optional<Nearness> meeting(const Leg& a, const Leg& b, double distance_m) {
  const Instant from = std::max(a.from, b.from), to = std::min(a.to, b.to);
  if (from >= to) return std::nullopt;
  const Place r = minus(b.at(from), a.at(from));
  const Place v = minus(minus(b.at(to), a.at(to)), r);
  const double vv = dot(v, v), rv = dot(r, v), rr = dot(r, r);
  const double nearest = vv > 0.0 ? std::clamp(-rv / vv, 0.0, 1.0) : 0.0;
  const double least = rr + nearest * (2.0 * rv + nearest * vv);
  if (least >= distance_m * distance_m) return std::nullopt;
  double enters = 0.0, leaves = 1.0;
  if (vv > 0.0) {
    const double half = std::sqrt(std::max(0.0, rv * rv - vv * (rr - distance_m * distance_m)));
    enters = std::clamp((-rv - half) / vv, 0.0, 1.0);
    leaves = std::clamp((-rv + half) / vv, 0.0, 1.0);
  }
  const Seconds common = seconds(to - from);
  return Nearness{from + duration(enters * common), from + duration(leaves * common),
                  std::sqrt(std::max(0.0, least))};
}

// By the whole second in which they begin; a leg that reaches into the next stands in both.
std::map<Duration::rep, std::vector<Leg>> legs_by_second(const std::vector<AirTrack>& tracks) {
  std::map<Duration::rep, std::vector<Leg>> all;
  for (std::size_t t = 0; t < tracks.size(); ++t) {
    const auto& [points, landings] = tracks[t];
    for (std::size_t i = 1; i < points.size(); ++i) {
      const TrackPoint &a = points[i - 1], &b = points[i];
      if (b.at <= a.at || std::binary_search(landings.begin(), landings.end(), a.at)) continue;
      const Leg leg{t, a.at, b.at, place(a), place(b)};
      const auto last = (b.at.time_since_epoch() - Duration{1}) / one_second;
      for (auto s = a.at.time_since_epoch() / one_second; s <= last; ++s) all[s].push_back(leg);
    }
  }
  return all;
}

// Sweeps from west to east.
void meet(std::vector<Leg>& legs, double distance_m, Meetings& meetings) {
  std::sort(legs.begin(), legs.end(), [](const Leg& a, const Leg& b) {
    return std::tuple{a.west_m(), a.track, a.from} < std::tuple{b.west_m(), b.track, b.from};
  });
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const double reach_m = legs[i].east_m() + distance_m;
    for (std::size_t j = i + 1; j < legs.size() && legs[j].west_m() < reach_m; ++j) {
      if (legs[i].track == legs[j].track) continue;
      const auto near = meeting(legs[i], legs[j], distance_m);
      if (near) meetings[std::minmax(legs[i].track, legs[j].track)].push_back(*near);
    }
  }
}

// Stretches of one pair, joined where one goes over into the next.
void join(std::vector<Nearness> stretches, std::pair<std::size_t, std::size_t> pair,
          std::vector<Encounter>& encounters) {
  std::sort(stretches.begin(), stretches.end(),
            [](const Nearness& a, const Nearness& b) { return a.from < b.from; });
  const std::size_t before = encounters.size();
  for (const Nearness& n : stretches) {
    if (encounters.size() > before && n.from <= encounters.back().to + hair) {
      Encounter& last = encounters.back();
      last.to = std::max(last.to, n.to);
      last.closest_m = std::min(last.closest_m, n.closest_m);
    } else {
      encounters.push_back({pair.first, pair.second, n.from, n.to, n.closest_m});
    }
  }
}

}  // namespace

Separation separation(const std::vector<AirTrack>& tracks, double distance_m) {
  Meetings meetings;
  for (auto& [second, legs] : legs_by_second(tracks)) meet(legs, distance_m, meetings);
  Separation result{};
  for (auto& [pair, stretches] : meetings) join(std::move(stretches), pair, result.encounters);
  std::sort(result.encounters.begin(), result.encounters.end(),
            [](const Encounter& a, const Encounter& b) {
              return std::tie(a.from, a.first, a.second) < std::tie(b.from, b.first, b.second);
            });
  for (const Encounter& e : result.encounters) {
    result.closest_m = std::min(result.closest_m.value_or(e.closest_m), e.closest_m);
  }
  return result;
}

}  // namespace furrow::sim
