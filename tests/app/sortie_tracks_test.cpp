#include "app/exports/sortie_tracks.hpp"
#include "app/exports/missions_json.hpp"
#include "tests/app/results/small_mission.hpp"

#include <catch2/catch.hpp>

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

TEST_CASE("missions.json of version 1, which knew no landing place, is refused", "[app]") {
  const auto read = read_missions(R"({"version": 1, "datum": null, "sorties": []})");

  REQUIRE(!read);
  CHECK(read.error() == "version: must be 2 (got 1): plan the scenario again");
}

}  // namespace
}  // namespace furrow::app
