#include "scheduler/airspace.hpp"

#include "core/require.hpp"
#include "planner/coverage/plane.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace furrow::scheduler {
namespace {

constexpr double upright_room_m = 0.3, line_room_m = 0.5;
constexpr Duration period{100'000'000};  // to which aircraft keep time
constexpr Duration longest_delay{120'000'000'000};

using Place = std::array<double, 3>;  // [m], heights stretched

Place minus(const Place& a, const Place& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const Place& a, const Place& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// Between two places of a track, the heights stretched so that one distance counts in all
// directions.
struct Leg {
  Instant from, to;
  Place begin, end;

  Leg(const TimedPlace& a, const TimedPlace& b, double stretch)
      : from{a.at}, to{b.at}, begin{place(a, stretch)}, end{place(b, stretch)} {}
  Place at(Instant t) const {
    const double share = to > from ? seconds(t - from) / seconds(to - from) : 0.0;
    const Place way = minus(end, begin);
    return {begin[0] + share * way[0], begin[1] + share * way[1], begin[2] + share * way[2]};
  }
  static Place place(const TimedPlace& p, double stretch) {
    return {p.position.x.base(), p.position.y.base(), stretch * p.altitude_m};
  }
};

// Square of how near two come in the time that both legs have in common.
double nearest_m2(const Leg& a, const Leg& b, Instant from, Instant to) {
  const Place r = minus(b.at(from), a.at(from));
  const Place v = minus(minus(b.at(to), a.at(to)), r);
  const double vv = dot(v, v);
  const double share = vv > 0.0 ? std::clamp(-dot(r, v) / vv, 0.0, 1.0) : 0.0;
  return dot(r, r) + share * (2.0 * dot(r, v) + share * vv);
}

bool meet(const std::vector<TimedPlace>& one, const std::vector<TimedPlace>& other, double level_m,
          double stretch) {
  std::size_t j = 1;
  for (std::size_t i = 1; i < one.size(); ++i) {
    const Leg a{one[i - 1], one[i], stretch};
    while (j + 1 < other.size() && other[j].at < a.from) ++j;
    for (std::size_t k = j; k < other.size() && other[k - 1].at <= a.to; ++k) {
      const Leg b{other[k - 1], other[k], stretch};
      const Instant from = std::max(a.from, b.from), to = std::min(a.to, b.to);
      if (from <= to && nearest_m2(a, b, from, to) < level_m * level_m) return true;
    }
  }
  return false;
}

std::vector<TimedPlace> put_off(std::vector<TimedPlace> track, Duration delay) {
  for (TimedPlace& place : track) place.at += delay;
  return track;
}

// A stretch of a leg in plan, and when it is flown.
struct Stretch {
  planner::PointM from, to;
  Instant enters, leaves;
};

// The part of a leg that is less than `upright_m` above a height.
std::optional<Stretch> low_part(const TimedPlace& a, const TimedPlace& b, double altitude_m,
                                double upright_m) {
  const double above_a = a.altitude_m - altitude_m, above_b = b.altitude_m - altitude_m;
  if (std::min(above_a, above_b) >= upright_m) return std::nullopt;
  const double passes = above_a == above_b ? 0.0 : (upright_m - above_a) / (above_b - above_a);
  const double first = above_a > upright_m ? passes : 0.0,
               last = above_b > upright_m ? passes : 1.0;
  const auto at = [&](double share) {
    return planner::PointM{std::lerp(a.position.x.base(), b.position.x.base(), share),
                           std::lerp(a.position.y.base(), b.position.y.base(), share)};
  };
  const Seconds length = seconds(b.at - a.at);
  return Stretch{at(first), at(last), a.at + duration(first * length),
                 a.at + duration(last * length)};
}

planner::PointM plane(FieldPoint p) { return {p.x.base(), p.y.base()}; }

planner::BoxM box(const WorkSite& site) {
  return planner::box_of(plane(site.from), plane(site.to));
}

}  // namespace

Airspace::Airspace(Length distance)
    : level_m_{distance.base() + level_room_m},
      upright_m_{distance.base() + upright_room_m},
      line_m_{distance.base() + line_room_m} {
  require(distance > Length{}, "aircraft keep a distance");
}

std::optional<FlightGrant> Airspace::answer(const FlightClaim& claim,
                                            const std::vector<WorkSite>& sites, Length near,
                                            Instant now) {
  std::erase_if(flights_, [now](const Flight& f) { return f.track.back().at < now; });
  for (const Flight& f : flights_) {
    if (f.agent == claim.agent && f.grant.claim >= claim.claim) return f.grant;
  }
  if (claim.departure == Departure::begun) return book(claim, Duration{});
  const std::vector<Pass> low = passes(claim, sites, near, now);
  if (claim.departure == Departure::in_motion) {
    if (is_clear(claim, low, Duration{})) return book(claim, Duration{});
    return FlightGrant{claim.agent, claim.boot, claim.claim, false, now};
  }
  std::erase_if(flights_, [&](const Flight& f) { return f.agent == claim.agent; });  // given up
  const auto put_off = delay(claim, low, now);
  return put_off ? std::optional{book(claim, *put_off)} : std::nullopt;
}

std::optional<Airspace::Arrival> Airspace::arrival(AgentId agent, Instant now) const {
  for (const Flight& f : flights_) {
    if (f.agent == agent && f.track.back().at >= now) return Arrival{f.track.back(), f.leads_to};
  }
  return std::nullopt;
}

bool Airspace::is_clear(const std::vector<WorkSite>& own, const std::vector<WorkSite>& others,
                        Length near, Instant now) const {
  std::vector<Pass> found;
  for (const WorkSite& site : own) {
    for (const Flight& f : flights_) {
      if (f.agent != site.agent) add_passes(f.track, site, true, found);
    }
    add_near(site, others, near, now, found);
  }
  return std::none_of(found.begin(), found.end(), [](const Pass& p) { return p.meets({}); });
}

// Of the claimed track by the others' sites, of the others' tracks by the claimant's, and of these
// by each other.
std::vector<Airspace::Pass> Airspace::passes(const FlightClaim& claim,
                                             const std::vector<WorkSite>& sites, Length near,
                                             Instant now) const {
  std::vector<Pass> found;
  for (const WorkSite& site : sites) {
    if (site.agent != claim.agent) {
      add_passes(claim.track, site, false, found);
      continue;
    }
    for (const Flight& f : flights_) {
      if (f.agent != claim.agent) add_passes(f.track, site, true, found);
    }
    add_near(site, sites, near, now, found);
  }
  return found;
}

// Of a site by others' that are near it. How late somebody is at work grows with the way there.
void Airspace::add_near(const WorkSite& own, const std::vector<WorkSite>& others, Length near,
                        Instant now, std::vector<Pass>& found) {
  constexpr double late_share = 0.3;
  const auto latest = [now](const WorkSite& site) {
    return site.leaves == never ? never
                                : site.leaves + duration(late_share * seconds(site.leaves - now));
  };
  const planner::BoxM reach = planner::grown(box(own), near.base());
  for (const WorkSite& other : others) {
    const bool is_near = other.agent != own.agent && planner::overlap(reach, box(other)) &&
                         planner::apart_m(plane(own.from), plane(own.to), plane(other.from),
                                          plane(other.to)) < near.base();
    if (is_near) found.push_back({own.enters, latest(own), other.enters, latest(other)});
  }
}

// But for those that are over before the claimant is there, however long it is put off.
void Airspace::add_passes(const Track& track, const WorkSite& site, bool is_own,
                          std::vector<Pass>& found) const {
  for (std::size_t i = 1; i < track.size(); ++i) {
    const TimedPlace &a = track[i - 1], &b = track[i];
    if (is_own ? b.at < site.enters : site.leaves < a.at) continue;
    const auto low = low_part(a, b, site.altitude_m, upright_m_);
    const bool is_near =
        low && planner::apart_m(low->from, low->to, plane(site.from), plane(site.to)) < line_m_;
    if (!is_near) continue;
    found.push_back(is_own ? Pass{site.enters, site.leaves, low->enters, low->leaves}
                           : Pass{low->enters, low->leaves, site.enters, site.leaves});
  }
}

bool Airspace::is_clear(const FlightClaim& claim, const std::vector<Pass>& passes,
                        Duration delay) const {
  const bool is_met =
      std::any_of(passes.begin(), passes.end(), [delay](const Pass& p) { return p.meets(delay); });
  if (is_met) return false;
  const Track track = put_off(claim.track, delay);
  return std::none_of(flights_.begin(), flights_.end(), [&](const Flight& f) {
    return f.agent != claim.agent && meet(track, f.track, level_m_, level_m_ / upright_m_);
  });
}

std::optional<Duration> Airspace::delay(const FlightClaim& claim, const std::vector<Pass>& passes,
                                        Instant now) const {
  const auto late = std::max(Duration{}, now - claim.track.front().at);
  const Duration least = (late + period - Duration{1}) / period * period;
  for (Duration d = least; d <= least + longest_delay; d += step) {
    if (is_clear(claim, passes, d)) return d;
  }
  return std::nullopt;
}

// Who hovers until it may begin is where it begins.
FlightGrant Airspace::book(const FlightClaim& claim, Duration delay) {
  std::erase_if(flights_, [&](const Flight& f) { return f.agent == claim.agent; });
  Track track = put_off(claim.track, delay);
  const FlightGrant grant{claim.agent, claim.boot, claim.claim, true, track.front().at};
  if (claim.departure == Departure::from_hover && delay > Duration{}) {
    track.insert(track.begin(), claim.track.front());
  }
  flights_.push_back({claim.agent, claim.leads_to, grant, std::move(track)});
  return grant;
}

}  // namespace furrow::scheduler
