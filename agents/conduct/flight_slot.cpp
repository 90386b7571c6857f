#include "agents/conduct/flight_slot.hpp"

#include <utility>

namespace furrow::agents {

const FlightClaim& FlightSlot::ask(FlightClaim flight) {
  grant_.reset();
  flight.claim = ++claims_;
  return claim_.emplace(std::move(flight));
}

bool FlightSlot::accept(const FlightGrant& grant, BootId boot) {
  const bool is_ours = is_open() && grant.claim == claim_->claim && grant.target_boot == boot;
  if (is_ours) grant_ = grant;
  return is_ours;
}

}  // namespace furrow::agents
