#include "transport/director.hpp"

#include "transport/granted_director.hpp"
#include "transport/recorder.hpp"
#include "transport/wall_director.hpp"

#include <memory>

namespace furrow::transport {

Expected<DirectorResult, TransportError> run_director(const DirectorSettings& settings) {
  const bool wall = settings.epoch_realtime_ns.has_value();
  Incoming incoming;
  auto participant = Participant::join(settings.network, director_participant,
                                       wall ? TimeMode::wall : TimeMode::granted,
                                       [&](std::uint32_t lost) { incoming.lose(lost); });
  if (!participant) return Unexpected{participant.error()};
  return wall ? run_wall_director(settings, **participant, incoming)
              : run_granted_director(settings, **participant, incoming);
}

}  // namespace furrow::transport
