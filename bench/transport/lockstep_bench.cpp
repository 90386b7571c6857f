// Rounds of granted time per second: so many agents, so many in each process, beside a scheduler
// and one station, or two for more than eight agents.

#include "tests/transport/toy_run.hpp"

#include <benchmark/benchmark.h>

namespace furrow {
namespace {

void lockstep(benchmark::State& state) {
  const auto lock = transport::DomainLock::any_free();
  const auto agents = static_cast<std::uint32_t>(state.range(0));
  const toy::Run run{.fleet = {.agents = agents, .stations = agents > 8 ? 2u : 1u, .seconds = 60},
                     .domain = lock->domain(),
                     .agents_per_process = static_cast<std::uint32_t>(state.range(1))};
  std::uint64_t rounds = 0;
  double messages = 0;
  for (auto _ : state) {
    toy::Children children{run};
    auto settings = toy::director(run, children);
    std::chrono::steady_clock::time_point begin{};
    settings.observer = [&](const Envelope&) {
      if (begin.time_since_epoch().count() == 0) begin = std::chrono::steady_clock::now();
    };
    const auto result = run_director(settings);
    if (!result) {
      state.SkipWithError(result.error().what.c_str());
      return;
    }
    // The start of the processes is not counted.
    const auto took = std::chrono::steady_clock::now() - begin;
    state.SetIterationTime(std::chrono::duration<double>(took).count());
    rounds += result->rounds;
    messages += static_cast<double>(result->log.size());
  }
  state.counters["rounds/s"] =
      benchmark::Counter(static_cast<double>(rounds), benchmark::Counter::kIsRate);
  state.counters["messages/round"] = messages / static_cast<double>(rounds);
  state.counters["x_real_time"] = benchmark::Counter(60.0 * static_cast<double>(state.iterations()),
                                                     benchmark::Counter::kIsRate);
}
BENCHMARK(lockstep)
    ->ArgNames({"agents", "per_process"})
    ->Args({1, 1})
    ->Args({8, 1})
    ->Args({20, 1})
    ->Args({20, 10})
    ->UseManualTime()
    ->Unit(benchmark::kSecond);

}  // namespace
}  // namespace furrow
