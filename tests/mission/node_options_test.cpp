#include "mission/node_options.hpp"

#include <catch2/catch.hpp>
#include <vector>

namespace furrow::mission {
namespace {

Expected<NodeOptions, std::string> options(std::vector<const char*> words) {
  words.insert(words.begin(), {"furrow-agents", "--scenario", "s.yaml", "--run", "r1"});
  return node_options(static_cast<int>(words.size()), words.data());
}

TEST_CASE("node_options: every option is read", "[mission]") {
  const auto o = options({"--seed", "18446744073709551615", "--domain", "7", "--participant", "12",
                          "--interface", "10.0.0.1", "--peer", "10.0.0.2", "--mode", "wall",
                          "--epoch-ns", "1700000000000000000", "--agents", "1-50", "--boot", "99"});

  REQUIRE(o);
  CHECK(o->scenario == "s.yaml");
  CHECK(o->seed == UINT64_MAX);
  CHECK(o->domain == 7);
  CHECK(o->run == "r1");
  CHECK(o->participant == 12);
  CHECK(o->interface == "10.0.0.1");
  CHECK(o->peers == std::vector<std::string>{"10.0.0.2"});
  CHECK(o->mode == NodeOptions::Mode::wall);
  CHECK(o->epoch_ns == 1'700'000'000'000'000'000);
  CHECK(o->first == 1);
  CHECK(o->last == 50);
  CHECK(o->boot == BootId{99});
}

TEST_CASE("node_options: what is left out has its default", "[mission]") {
  const auto o = options({});

  REQUIRE(o);
  CHECK_FALSE(o->seed);
  CHECK(o->domain == 0);
  CHECK(o->participant == 0);
  CHECK(o->interface == "127.0.0.1");
  CHECK(o->mode == NodeOptions::Mode::granted);
  CHECK(o->first == 0);
  CHECK(o->last == 0);
}

TEST_CASE("node_options: one agent or one station is a range of one", "[mission]") {
  const auto agent = options({"--agents", "7"}), station = options({"--station", "2"});

  REQUIRE(agent);
  CHECK(agent->first == 7);
  CHECK(agent->last == 7);
  REQUIRE(station);
  CHECK(station->first == 2);
  CHECK(station->last == 2);
}

TEST_CASE("node_options: what is not an option or out of range is an error", "[mission]") {
  for (const char* range : {"0", "5-4", "1-", "-3", "a", "1-2-3", "1 -2", "99999999999"}) {
    const std::string word = std::string{"--agents="} + range;
    const auto o = options({word.c_str()});
    INFO(range);
    REQUIRE_FALSE(o);
    CHECK(o.error() ==
          std::string{"--agents: must be a number or a range like 1-50 (got "} + range + ")");
  }
  CHECK_FALSE(options({"--domain", "233"}));
  CHECK_FALSE(options({"--participant", "-1"}));
  CHECK_FALSE(options({"--mode", "fast"}));
  CHECK_FALSE(options({"--seed", "-1"}));
  CHECK_FALSE(options({"--boot", "-1"}));
  CHECK_FALSE(options({"--station", "1-2"}));
  CHECK_FALSE(options({"--station", "0"}));
  CHECK_FALSE(options({"--station", "1", "--agents", "1"}));
  CHECK_FALSE(options({"--agent", "1"}));
  const char* bare[] = {"furrow-agents"};
  CHECK_FALSE(node_options(1, bare));
}

}  // namespace
}  // namespace furrow::mission
