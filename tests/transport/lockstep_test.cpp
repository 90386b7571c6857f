#include "bytes.hpp"
#include "toy_run.hpp"

#include <catch2/catch.hpp>

#include <csignal>

namespace furrow {
namespace {

TEST_CASE("lockstep: two processes give the log of one host", "[transport]") {
  const auto lock = transport::DomainLock::any_free();
  REQUIRE(lock);
  const toy::Run run{.fleet = {.agents = 1, .stations = 0, .seconds = 5}, .domain = lock->domain()};
  toy::Children children{run};
  const auto result = run_director(toy::director(run, children));
  if (!result) FAIL(result.error().what);
  CHECK(result->ending == transport::Ending::finished);
  CHECK((bytes(result->log) == bytes(toy::log_in_one_host(run.fleet))));
  CHECK(children.exit_codes() == std::map<std::uint32_t, int>{{1, 0}, {2, 0}});
}

TEST_CASE("lockstep: four processes on a bad radio give the log of one host, every time",
          "[transport]") {
  const auto lock = transport::DomainLock::any_free();
  REQUIRE(lock);
  const toy::Run run{.fleet = {.agents = 5, .stations = 1, .seconds = 20},
                     .domain = lock->domain(),
                     .agents_per_process = 3};
  const auto expected = bytes(toy::log_in_one_host(run.fleet));
  for (int i = 0; i < 5; ++i) {
    toy::Children children{run};
    const auto result = run_director(toy::director(run, children));
    if (!result) FAIL(result.error().what);
    CHECK(result->end == Instant{20 * toy::second});
    CHECK((bytes(result->log) == expected));  // no printing of a thousand lines
    for (const auto& [participant, code] : children.exit_codes()) CHECK(code == 0);
  }
}

TEST_CASE("lockstep: when a member dies the rest goes on", "[transport]") {
  const auto lock = transport::DomainLock::any_free();
  REQUIRE(lock);
  const toy::Run run{.fleet = {.agents = 3, .stations = 1, .seconds = 30},
                     .domain = lock->domain()};
  toy::Children children{run};
  auto settings = toy::director(run, children);
  constexpr std::uint32_t victim = 4;  // agent 2: after the scheduler, the station and agent 1
  settings.observer = [&](const Envelope& e) {
    if (e.sent >= Instant{10 * toy::second}) children[victim].signal(SIGKILL);
  };
  const auto result = run_director(settings);
  if (!result) FAIL(result.error().what);
  CHECK(result->ending == transport::Ending::finished);
  CHECK(result->end == Instant{30 * toy::second});
  CHECK(result->died == std::vector<std::uint32_t>{victim});
  CHECK(children.exit_codes() ==
        std::map<std::uint32_t, int>{{1, 0}, {2, 0}, {3, 0}, {4, 137}, {5, 0}});
}

}  // namespace
}  // namespace furrow
