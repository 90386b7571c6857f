#include "app/operator_desk.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <future>
#include <unistd.h>

namespace furrow::app {
namespace {

using std::chrono::seconds;

std::filesystem::path own_folder() {
  return std::filesystem::temp_directory_path() / ("operated-" + std::to_string(::getpid()));
}

Envelope answer(std::uint64_t order, std::string refusal = {}) {
  return {scheduler_node(), 1, Instant{std::chrono::milliseconds{12'300}},
          OperatorState{.epoch = Epoch{1},
                        .revision = 1,
                        .level = FleetLevel::hold,
                        .taken_out = {},
                        .answered = order,
                        .refusal = std::move(refusal)}};
}

// Calls as the command does, while the desk is asked as a director asks it.
Answer called(OperatorDesk& desk, const std::string& line, const Envelope& told,
              std::size_t& orders) {
  auto reply =
      std::async(std::launch::async, [&] { return call_run(own_folder(), line, seconds{10}); });
  while (reply.wait_for(std::chrono::milliseconds{5}) != std::future_status::ready) {
    const auto said = desk.says();
    orders += said.size();
    if (!said.empty()) desk.observe(told);
  }
  const auto got = reply.get();
  REQUIRE(got);
  REQUIRE(*got);
  return **got;
}

TEST_CASE("operator_order: reads each order and names the rule that another breaks", "[app]") {
  CHECK(operator_order("pause", 2)->ask == OperatorAsk::pause);
  CHECK(operator_order("return_all", 2)->ask == OperatorAsk::return_all);
  CHECK(operator_order("take_out 2", 2)->agent == AgentId{2});
  CHECK(operator_order("land", 2).error() ==
        "order: must be pause, resume, return_all, stop or take_out (got land)");
  for (const char* uav : {"0", "3", "-1", "2x", ""}) {
    const auto order = operator_order(std::string{"take_out "} + uav, 2);
    REQUIRE_FALSE(order);
    CHECK(order.error().starts_with("uav: must be the number of a UAV of the mission, 1 to 2"));
  }
  CHECK(operator_order("stop 1", 2).error() ==
        "uav: must be left out of orders to the whole fleet (got 1)");
}

TEST_CASE("operator_desk: says an order to the fleet and its answer to the caller", "[app]") {
  auto line = OperatorLine::open(own_folder());
  REQUIRE(line);
  CHECK_FALSE(OperatorLine::open(own_folder()));  // one run for a folder
  OperatorDesk desk{std::move(*line), 2};
  std::size_t orders = 0;
  const Answer obeyed = called(desk, "pause", answer(1), orders);
  CHECK(obeyed.code == 0);
  CHECK(obeyed.text == "obeyed at 12.3 s");
  const Answer refused = called(desk, "take_out 2", answer(2, "agent 2 is lost"), orders);
  CHECK(refused.code == 1);
  CHECK(refused.text == "refused at 12.3 s: agent 2 is lost");
  CHECK(orders == 2);
  CHECK(called(desk, "take_out 3", answer(3), orders).code == 2);
  CHECK(orders == 2);  // what is wrong in itself does not reach the fleet
}

TEST_CASE("operator_line: a call to a run that is not there, or does not answer, is told so",
          "[app]") {
  const auto alone = call_run(own_folder(), "pause", seconds{1});
  REQUIRE_FALSE(alone);
  CHECK(alone.error().starts_with("no run is going on that writes its results to "));
  const auto line = OperatorLine::open(own_folder());
  REQUIRE(line);
  const auto unanswered = call_run(own_folder(), "pause", seconds{1});
  REQUIRE(unanswered);
  CHECK_FALSE(*unanswered);
}

}  // namespace
}  // namespace furrow::app
