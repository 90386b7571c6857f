#include "agents/conduct/flight_slot.hpp"

#include <utility>

namespace furrow::agents {

const FlightClaim& FlightSlot::ask(AgentId agent, BootId boot, Departure departure,
                                   std::vector<TimedPlace> track) {
  grant_.reset();
  return claim_.emplace(FlightClaim{agent, boot, ++claims_, departure, std::move(track)});
}

bool FlightSlot::accept(const FlightGrant& grant, BootId boot) {
  const bool is_ours = is_open() && grant.claim == claim_->claim && grant.target_boot == boot;
  if (is_ours) grant_ = grant;
  return is_ours;
}

}  // namespace furrow::agents
