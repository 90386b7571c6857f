// One control period of one aircraft on strips: senses, decides, moves, records. Nanoseconds per
// period is the figure; 20 aircraft at 1000 times real time on one core allow 5000 ns.

#include "tests/agents/scripted_fleet.hpp"

#include <benchmark/benchmark.h>

namespace furrow::agents {
namespace {

const Wind breeze{.mean = metres_per_second(6), .from_deg = 250, .gust = metres_per_second(1.5)};

Vehicle surveyed() {
  Vehicle v = sprayer();
  v.gnss = {.sigma = metres(0.02), .bias = {}};
  return v;
}

// The node alone, woken as it asks for, over a sortie of 2 400 m.
void agent_on_strips(benchmark::State& state) {
  const auto pieces = strips(12, 100);
  const Command command{agent_7, boot_1, Epoch{1}, 1, {{pieces, StationId{1}}}};
  WorkGrant grant{agent_7, boot_1, Epoch{1}, 1, 0, {}};
  for (std::uint32_t i = 0; i < 12; ++i) grant.windows.push_back({i + 1, {i * 100, 100}});
  const Inbox orders{{scheduler_node(), 1, {}, command}, {scheduler_node(), 2, {}, grant}};
  constexpr Instant until = Instant{} + 780 * second;

  double periods = 0.0, steps = 0.0;
  for (auto _ : state) {
    AgentNode agent{settings_of(surveyed(), breeze)};
    Instant now = agent.step({}, Instant{}).wake;
    Outbox out = agent.step(orders, now);
    for (now = out.wake; now < until; now = out.wake) {
      out = agent.step({}, now);
      benchmark::DoNotOptimize(out);
      ++steps;
    }
    periods += 7800.0;
  }
  state.counters["ns_per_period"] =
      benchmark::Counter(periods * 1e-9, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["periods_per_step"] = periods / steps;
}
BENCHMARK(agent_on_strips)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace furrow::agents
