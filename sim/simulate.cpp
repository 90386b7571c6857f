#include "sim/simulate.hpp"

#include "core/require.hpp"

#include <algorithm>
#include <iterator>

namespace furrow::sim {

bool ends_mission(const Envelope& envelope) {
  const auto* state = std::get_if<SchedulerState>(&envelope.body);
  return state != nullptr && state->phase == MissionPhase::finished;
}

Log simulate(NodeHost& host, Duration latency, Instant limit, const Watch& watch) {
  require(latency > Duration::zero(), "messages take time, or no order of events is defined");
  Log log{.envelopes = {}, .ended = limit, .finished = false};

  for (Instant next = host.next_event(); next < limit; next = host.next_event()) {
    std::vector<Envelope> sent = host.advance(std::min(next + latency, limit));
    for (const Envelope& envelope : sent) host.deliver(envelope);

    const auto last = std::find_if(sent.begin(), sent.end(), ends_mission);
    if (last != sent.end()) {
      log.finished = true;
      log.ended = last->sent;
      std::erase_if(sent, [&](const Envelope& e) { return e.sent > log.ended; });
    }
    const bool goes_on = !watch || watch(sent);
    if (!goes_on && !log.finished && !sent.empty()) log.ended = sent.back().sent;
    std::move(sent.begin(), sent.end(), std::back_inserter(log.envelopes));
    if (log.finished || !goes_on) break;
  }
  return log;
}

}  // namespace furrow::sim
