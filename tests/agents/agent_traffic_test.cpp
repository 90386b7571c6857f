// The air that it shares: claimed, waited for, kept to.

#include "tests/agents/scripted_fleet.hpp"

#include <catch2/catch.hpp>

namespace furrow::agents {
namespace {

AgentSettings in_company(const Vehicle& vehicle = sprayer()) {
  AgentSettings settings = settings_of(vehicle);
  settings.airspace = AirspaceRule{.layer = metres(6)};
  return settings;
}

FlightGrant clear(const FlightClaim& c, Duration after) {
  return {c.agent, c.boot, c.claim, true, c.track.front().at + after};
}

FlightGrant refused(const FlightClaim& c) { return {c.agent, c.boot, c.claim, false, Instant{}}; }

double flight_s(const std::vector<Envelope>& log) {
  return all<SortieReport>(log).front().flight.base();
}

TEST_CASE(
    "traffic: it takes off at the instant it is given, and claims each way before it flies it",
    "[agents]") {
  ScriptedScheduler scheduler = three_strips();
  Instant given{};
  scheduler.clears = [&](const FlightClaim& c) {
    const bool is_first = c.claim == 1;
    if (is_first) given = c.track.front().at + 20 * second;
    return clear(c, is_first ? 20 * second : Duration{});
  };
  const auto log = fly(in_company(), scheduler, an_hour);
  CHECK(each_once(log, 300));
  const auto sorties = all<SortieReport>(log);
  REQUIRE(sorties.size() == 2);
  CHECK(sorties[0].began == given);
  std::vector<Departure> asked;
  std::uint64_t last = 0;
  for (const FlightClaim& c : all<FlightClaim>(log)) {
    if (std::exchange(last, c.claim) != c.claim) asked.push_back(c.departure);
  }
  CHECK(asked == std::vector{Departure::from_ground, Departure::in_motion, Departure::from_ground,
                             Departure::in_motion});
}

TEST_CASE("traffic: where all is clear a flight takes as long as alone, but in its layer",
          "[agents]") {
  const auto alone = fly(settings_of(sprayer()), three_strips(), an_hour);
  const auto log = fly(in_company(), three_strips(), an_hour);
  CHECK(flight_s(log) == Approx(flight_s(alone)).margin(0.15));
  double highest_m = 0.0, highest_at_work_m = 0.0;
  for (const FlightRecord& record : all<FlightRecord>(log)) {
    for (const TrackPoint& p : record.track) {
      highest_m = std::max(highest_m, p.altitude_m);
      if (p.spraying) highest_at_work_m = std::max(highest_at_work_m, p.altitude_m);
    }
  }
  CHECK(highest_m == Approx(6));
  CHECK(highest_at_work_m < 0.3);
}

TEST_CASE("traffic: it hovers at the end of its work until the way home is clear", "[agents]") {
  ScriptedScheduler scheduler = three_strips();
  scheduler.clears = [](const FlightClaim& c) -> std::optional<FlightGrant> {
    if (c.departure == Departure::in_motion) return refused(c);
    return clear(c, c.departure == Departure::from_hover ? 30 * second : Duration{});
  };
  const auto log = fly(in_company(), scheduler, an_hour);
  CHECK(each_once(log, 300));
  // 30 s, and at most 4 s for coming to rest, asking and starting again.
  const double longer_s = flight_s(log) - flight_s(fly(in_company(), three_strips(), an_hour));
  CHECK(longer_s > 30.0);
  CHECK(longer_s < 34.0);
}

/// Two strips of 100 m in one sortie, 60 m apart.
ScriptedScheduler two_far_strips() {
  std::vector<Piece> pieces = strips(2, 50);
  for (FieldPoint* p : {&pieces[1].entry, &pieces[1].from, &pieces[1].to, &pieces[1].exit}) {
    p->x = metres(63);
  }
  pieces[1].entry = pieces[1].from;
  return {.sorties = {{.pieces = pieces, .station = StationId{1}}}};
}

TEST_CASE("traffic: the way to far work of the same sortie is claimed as those from stations are",
          "[agents]") {
  ScriptedScheduler scheduler = two_far_strips();
  SECTION("and flown without a stop where it is clear") {
    const auto log = fly(in_company(), two_far_strips(), an_hour);
    CHECK(each_once(log, 100));
    std::vector<CellRange> asked;
    for (const FlightClaim& c : all<FlightClaim>(log)) {
      if (asked.empty() || !(asked.back() == c.leads_to)) asked.push_back(c.leads_to);
    }
    CHECK(asked == std::vector<CellRange>{{0, 50}, {50, 50}, {0, 0}});
    CHECK(flight_s(log) ==
          Approx(flight_s(fly(settings_of(sprayer()), two_far_strips(), an_hour))).margin(0.15));
  }
  SECTION("and waited for where it is not") {
    scheduler.clears = [](const FlightClaim& c) -> std::optional<FlightGrant> {
      if (c.departure == Departure::in_motion && c.leads_to.count > 0) return refused(c);
      return clear(c, c.departure == Departure::from_hover ? 30 * second : Duration{});
    };
    const auto log = fly(in_company(), scheduler, an_hour);
    CHECK(each_once(log, 100));
    // 30 s, and at most 4 s for coming to rest, asking and starting again.
    const double longer_s = flight_s(log) - flight_s(fly(in_company(), two_far_strips(), an_hour));
    CHECK(longer_s > 30.0);
    CHECK(longer_s < 34.0);
  }
  SECTION("and given up for the way home where the pack does not last") {
    Vehicle v = sprayer();
    v.flight_endurance = seconds(200);
    scheduler.clears = [](const FlightClaim& c) -> std::optional<FlightGrant> {
      const bool is_hop = c.departure != Departure::from_ground && c.leads_to.count > 0;
      return is_hop ? std::nullopt : std::optional{clear(c, Duration{})};
    };
    const auto log = fly(in_company(v), scheduler, an_hour);
    CHECK(contains(event_kinds(log), "return_early"));
    CHECK_FALSE(contains(event_kinds(log), "flies_unasked"));
    CHECK(each_once(log, 100));
    CHECK(all<SortieReport>(log).size() == 2);
  }
}

TEST_CASE("traffic: it flies home unasked when its pack lasts no longer", "[agents]") {
  Vehicle v = sprayer();
  v.flight_endurance = seconds(140);
  ScriptedScheduler scheduler{.sorties = two_sorties(strips(2, 50), 49)};
  scheduler.clears = [](const FlightClaim& c) -> std::optional<FlightGrant> {
    if (c.departure != Departure::from_ground) return std::nullopt;
    return clear(c, Duration{});
  };
  const auto log = fly(in_company(v), scheduler, an_hour);
  CHECK(contains(event_kinds(log), "flies_unasked"));
  CHECK_FALSE(contains(event_kinds(log), "pack_empty"));
  CHECK(each_once(log, 100));
}

TEST_CASE("traffic: an answer that comes too late is none, and it asks further ahead", "[agents]") {
  const Link slow{.latency = Duration{400'000'000}, .jitter = {}, .loss = 0, .duplication = 0};
  const auto log = fly(in_company(), three_strips(), an_hour, slow);
  CHECK(each_once(log, 300));
  CHECK(all<SortieReport>(log).size() == 2);
}

}  // namespace
}  // namespace furrow::agents
