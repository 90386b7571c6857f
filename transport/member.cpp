#include "transport/member.hpp"

#include "transport/granted_member.hpp"
#include "transport/wall_member.hpp"

#include <spdlog/spdlog.h>

namespace furrow::transport {

int run_member(const MemberSettings& settings, NodeHost host) {
  const auto end = settings.epoch_realtime_ns ? run_wall_member(settings, std::move(host))
                                              : run_granted_member(settings, std::move(host));
  if (end) return 0;
  spdlog::error("participant {}: {}", settings.participant, end.error().what);
  return 1;
}

}  // namespace furrow::transport
