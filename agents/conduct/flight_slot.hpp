#pragma once

#include "core/messages.hpp"

#include <optional>
#include <vector>

namespace furrow::agents {

/// What one aircraft has claimed of the air, and what became of it.
class FlightSlot {
 public:
  /// Claims a flight in place of the last one. @return What to tell the scheduler.
  /// @param flight  Its number is given here.
  const FlightClaim& ask(FlightClaim flight);

  /// Takes an answer to the last claim. @return Whether it is one, and news.
  bool accept(const FlightGrant& grant, BootId boot);

  /// Forgets the claim, whatever becomes of it.
  void drop() { claim_.reset(), grant_.reset(); }

  bool is_asked() const { return claim_.has_value(); }
  bool is_open() const { return claim_ && !grant_; }
  bool is_refused() const { return grant_ && !grant_->is_clear; }
  bool is_clear() const { return grant_ && grant_->is_clear; }

  /// @pre is_asked()
  const FlightClaim& claim() const { return *claim_; }
  /// @pre is_clear()
  Instant departs() const { return grant_->departs; }

 private:
  std::optional<FlightClaim> claim_{};
  std::optional<FlightGrant> grant_{};
  std::uint64_t claims_ = 0;
};

}  // namespace furrow::agents
