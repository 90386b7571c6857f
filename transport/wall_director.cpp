#include "transport/wall_director.hpp"

#include "transport/fleet_topics.hpp"
#include "transport/member.hpp"

#include <algorithm>
#include <optional>

namespace furrow::transport {

Expected<DirectorResult, TransportError> run_wall_director(const DirectorSettings& settings,
                                                           Participant& participant,
                                                           Incoming& incoming) {
  constexpr Duration grace{1'500'000'000};  // what members say on leaving is still recorded
  FleetTopics topics{participant,
                     role::director,
                     true,
                     TimeMode::wall,
                     BootId{1},
                     [&](Origin origin, std::size_t topic, std::optional<Envelope> e) {
                       incoming.put(origin, topic, std::move(e));
                     }};
  const auto now = [&] { return mission_now(*settings.epoch_realtime_ns); };
  Recorder recorder{settings};
  Watch watch{settings, incoming};
  std::optional<Instant> finished;

  const auto result = [&](Ending ending, Instant end) {
    return std::move(recorder).result(ending, end, watch.died(), 0, incoming.malformed());
  };
  for (;;) {
    incoming.wait_for_message(std::chrono::milliseconds{20});
    for (Sample& sample : incoming.take_messages()) {
      if (ends_mission(sample.envelope) && !finished) finished = now();
      recorder.keep(std::move(sample.envelope));
    }
    for (Envelope& word : recorder.own_words(std::max(now(), Instant{}))) {
      topics.publish(word);  // what is lost is said again
      recorder.keep(std::move(word));
    }
    if (finished && now() > *finished + grace) return result(Ending::finished, now());
    if (!finished) watch.new_deaths();  // leaving after the end is no death
    // At the limit the scheduler ends the mission itself, and its word takes a while.
    if (!finished && now() - grace > settings.mission_limit) {
      return result(Ending::mission_limit, settings.mission_limit);
    }
    const Instant end = std::max(now(), Instant{});  // the epoch may be yet to come
    if (watch.is_interrupted()) return result(Ending::interrupted, end);
    if (!watch.has_anyone()) return result(Ending::abandoned, end);
  }
}

}  // namespace furrow::transport
