#include "app/exports/sortie_tracks.hpp"
#include "app/exports/missions_json.hpp"
#include "tests/app/results/small_mission.hpp"

#include <catch2/catch.hpp>

#include <cmath>

namespace furrow::app {
namespace {

TEST_CASE("Every sortie takes off where the last one landed, and lands at the station", "[app]") {
  const MissionRecord record = small_plan();
  const auto tracks = sortie_tracks(record.plan);

  REQUIRE(tracks.size() == 3);
  CHECK(tracks[0].home == at_m(1, 1));
  CHECK(tracks[1].home == at_m(0, 0));
  CHECK(tracks[2].home == at_m(5, 1));
  for (const exchange::SortieTrack& track : tracks) CHECK(track.landing == at_m(0, 0));
}

TEST_CASE("missions.json gives back home, landing place and points", "[app]") {
  const auto tracks = sortie_tracks(small_plan().plan);
  const auto read = read_missions(missions_json({exchange::Datum{51.5, 4.25}, tracks}));

  REQUIRE(read);
  CHECK(read->datum == exchange::Datum{51.5, 4.25});
  REQUIRE(read->sorties.size() == tracks.size());
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    CHECK(read->sorties[i].home == tracks[i].home);
    CHECK(read->sorties[i].landing == tracks[i].landing);
    REQUIRE(read->sorties[i].points.size() == tracks[i].points.size());
    CHECK(read->sorties[i].points.back().at == tracks[i].points.back().at);
  }
}

TEST_CASE("Over terrain every place has its own height, and the lines between keep it", "[app]") {
  // A hill of 2 m in the middle of the strips; home is at 2 exp(-((3 - 1)^2 + (4 - 1)^2) / 4) m.
  MissionRecord record = small_plan();
  const planner::AnalyticTerrain hill{.base = {},
                                      .peaks = {{at_m(3, 4), metres(2), metres(2), metres(2)}}};
  const planner::Relief relief{{.ground = hill, .rule = {.clearance = metres(4)}, .keep_out = {}},
                               {at_m(-10, -10), at_m(20, 20)}};
  record.plan.route.ferries = record.plan.route.ferries.over_ground(relief);
  const auto tracks = sortie_tracks(record.plan);

  REQUIRE(tracks.size() == 3);
  const exchange::SortieTrack& first = tracks.front();
  const double home_m = 2 * std::exp(-13.0 / 4);
  CHECK(first.take_off == metres(3));
  CHECK(first.landing_ground.base() == Approx(2 * std::exp(-25.0 / 4) - home_m).margin(0.01));
  CHECK(first.points.size() > 4);
  double highest_m = 0;
  for (std::size_t i = 0; i < first.points.size(); ++i) {
    const exchange::TrackPoint& p = first.points[i];
    const double ground_m = relief.surface().height(p.at).base() - home_m;
    CHECK(p.ground.base() == Approx(ground_m).margin(0.01));
    CHECK(p.altitude.base() - ground_m > 3 - 0.01);
    highest_m = std::max(highest_m, p.altitude.base());
    if (i == 0) continue;
    const exchange::TrackPoint& before = first.points[i - 1];
    for (double t = 0; t <= 1; t += 0.1) {
      const FieldVector leg = p.at - before.at;
      const FieldPoint at = before.at + FieldVector{t * leg.x, t * leg.y};
      const double over_m = std::lerp(before.altitude.base(), p.altitude.base(), t) + home_m;
      // Drawn 0.25 m off; and heights are 2 m apart, where the hill bends by up to 1 / m: 0.5 m.
      CHECK(over_m - relief.surface().height(at).base() > 3 - 0.25 - 0.5);
    }
  }
  // The strips are 1 m beside its middle: 2 exp(-1 / 4) m at their highest, and 3 m over that.
  CHECK(highest_m + home_m > 4.3);
  const auto read = read_missions(missions_json({{}, tracks}));
  REQUIRE(read);
  CHECK(read->sorties[0].points[1].altitude == first.points[1].altitude);
  CHECK(read->sorties[0].points[1].ground == first.points[1].ground);
}

TEST_CASE("missions.json of version 1, which knew no landing place, is refused", "[app]") {
  const auto read = read_missions(R"({"version": 1, "datum": null, "sorties": []})");

  REQUIRE(!read);
  CHECK(read.error() == "version: must be 3 (got 1): plan the scenario again");
}

}  // namespace
}  // namespace furrow::app
