#pragma once

#include "core/messages.hpp"

#include <algorithm>
#include <optional>

namespace furrow::agents {

/// One visit to a station: a claim for a bay, the service in it, and the release.
class BayVisit {
 public:
  /// @param claim  1, 2, 3, ... per agent.
  BayVisit(AgentId agent, BootId boot, StationId station, std::uint64_t claim, Instant arrived,
           bool swap, double fill);

  /// Takes a bay for this claim, of several the one with the highest token; or that there is none.
  /// @return  Whether it changed anything, or is to be answered because the visit is over.
  bool accept(const ServiceGrant& grant);

  /// Whether service has ended at `now` and is not yet released.
  bool is_served(Instant now) const;
  /// Leaves the bay.
  void release() { claim_.status = ClaimStatus::released; }

  /// What is given of what was claimed. Meaningless while waiting.
  bool swaps() const { return claim_.swap && grant_.swap; }
  double fills() const { return std::min(claim_.fill, grant_.fill); }

  /// The claim as it now stands, to be sent as heartbeat.
  const ServiceClaim& claim() const { return claim_; }
  /// Meaningless while waiting.
  const ServiceGrant& grant() const { return grant_; }
  bool is_waiting() const { return claim_.status == ClaimStatus::waiting; }
  /// The station has nothing left of what is claimed.
  bool is_refused() const { return is_waiting() && is_refused_; }
  bool is_released() const { return claim_.status == ClaimStatus::released; }

  /// Whether a released claim is still to be repeated, for the case that it was lost.
  bool repeat_release() { return releases_left_ > 0 && releases_left_-- > 0; }

 private:
  ServiceClaim claim_;
  ServiceGrant grant_{};
  bool is_refused_ = false;
  int releases_left_ = 2;
};

}  // namespace furrow::agents
