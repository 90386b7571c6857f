#include "sim/simulate.hpp"

#include "core/require.hpp"

#include <algorithm>
#include <iterator>

namespace furrow::sim {

Log simulate(NodeHost& host, Duration latency, Instant limit, const Watch& watch) {
  require(latency > Duration::zero(), "messages take time, or no order of events is defined");
  Log log{.envelopes = {}, .ended = limit, .finished = false};
  const Instant past_limit = limit == never ? never : limit + Duration{1};  // the limit counts

  for (Instant next = host.next_event(); next < past_limit; next = host.next_event()) {
    const Instant until = std::min(next + latency, past_limit);
    std::vector<Envelope> sent = host.advance(until);
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
    if (host.next_event() == never) log.ended = until - Duration{1};
  }
  return log;
}

}  // namespace furrow::sim
