#include "agents/conduct/bay_visit.hpp"

#include <utility>

namespace furrow::agents {

BayVisit::BayVisit(AgentId agent, BootId boot, StationId station, std::uint64_t claim,
                   Instant arrived, bool swap, double fill)
    : claim_{.agent = agent,
             .boot = boot,
             .station = station,
             .claim = claim,
             .first_claimed = arrived,
             .status = ClaimStatus::waiting,
             .token = 0,
             .swap = swap,
             .fill = fill} {}

bool BayVisit::accept(const ServiceGrant& grant) {
  if (grant.station != claim_.station || grant.claim != claim_.claim) return false;
  if (is_released()) return true;
  if (grant.bay == 0) return is_waiting() && !std::exchange(is_refused_, true);
  if (grant.token <= claim_.token) return false;
  grant_ = grant;
  claim_.token = grant.token;
  claim_.status = ClaimStatus::in_bay;
  return true;
}

bool BayVisit::is_served(Instant now) const {
  return claim_.status == ClaimStatus::in_bay && now >= grant_.ready;
}

}  // namespace furrow::agents
