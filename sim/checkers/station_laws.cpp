#include "sim/checkers/laws.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <optional>
#include <set>

namespace furrow::sim {
namespace {

constexpr Duration grace{2'000'000'000};  // T of L10, and the time a message may take to be heard

class StationLaws final : public Checker {
 public:
  explicit StationLaws(const Facts& facts) : facts_{facts} {
    for (const auto& uav : facts.plan.uavs) tanks_[uav.vehicle.id] = uav.vehicle.tank;
  }

  void observe(const Envelope& e) override {
    if (const auto* claim = std::get_if<ServiceClaim>(&e.body)) observe_claim(*claim, e.sent);
    if (const auto* grant = std::get_if<ServiceGrant>(&e.body)) observe_grant(*grant, e.sent);
    if (const auto* state = std::get_if<StationState>(&e.body)) observe_state(*state, e.sent);
  }

  void conclude(Instant) override {}

 private:
  struct Claim {
    ServiceClaim last;
    Instant first_heard, last_heard;
  };
  struct Holder {
    ServiceGrant grant;
    std::optional<Instant> released;
  };
  struct Books {
    std::map<AgentId, Claim> claims;          // the newest of each agent
    std::map<std::uint32_t, Holder> holders;  // the last of each bay
    std::set<std::uint64_t> tokens;
    std::set<std::pair<AgentId, std::uint64_t>> refused;  // visits that it cannot help
    std::uint32_t swaps = 0;
    double filled_l = 0.0;
    StationState last{};
  };

  void observe_claim(const ServiceClaim& claim, Instant at) {
    Books& books = books_[claim.station];
    const auto known = books.claims.find(claim.agent);
    const bool is_same = known != books.claims.end() && known->second.last.claim == claim.claim;
    books.claims[claim.agent] = {claim, is_same ? known->second.first_heard : at, at};
    if (claim.status != ClaimStatus::released) return;
    for (auto& [bay, holder] : books.holders) {
      if (is_of(holder.grant, claim) && !holder.released) holder.released = at;
    }
  }

  // Who leaves the queue may not know yet that a bay was given to it.
  static bool is_of(const ServiceGrant& grant, const ServiceClaim& claim) {
    return grant.agent == claim.agent && grant.claim == claim.claim;
  }

  void observe_grant(const ServiceGrant& grant, Instant at) {
    Books& books = books_[grant.station];
    if (grant.bay == 0) {
      books.refused.insert({grant.agent, grant.claim});
      return;
    }
    if (!books.tokens.insert(grant.token).second) {  // the same again
      return;
    }
    if (grant.token != *books.tokens.rbegin()) {
      report("L9", at,
             fmt::format("station {} gave token {} after {}", number(grant.station), grant.token,
                         *books.tokens.rbegin()));
    }
    check_hours(grant, at);
    check_bay(books, grant, at);
    check_turn(books, grant, at);
    const auto claim = books.claims.find(grant.agent);
    if (claim != books.claims.end()) {
      const auto tank = tanks_.find(grant.agent);
      const ServiceClaim& wanted = claim->second.last;
      books.swaps += wanted.swap && grant.swap;
      if (tank != tanks_.end()) {
        books.filled_l += std::min(wanted.fill, grant.fill) * tank->second.base();
      }
      check_stock(books, grant.station, at);
    }
    const bool has_left = claim != books.claims.end() && is_of(grant, claim->second.last) &&
                          claim->second.last.status == ClaimStatus::released;
    books.holders[grant.bay] = {grant, has_left ? std::optional{at} : std::nullopt};
  }

  void check_stock(const Books& books, StationId id, Instant at) {
    for (const Station& station : facts_.stations) {
      if (station.id != id) continue;
      const bool is_short = (station.packs && books.swaps > *station.packs) ||
                            (station.mix && books.filled_l > station.mix->base() + 1e-6);
      if (!is_short) continue;
      report("L12", at,
             fmt::format("station {} gave {} packs and {:.2f} l, more than it had", number(id),
                         books.swaps, books.filled_l));
    }
  }

  void check_hours(const ServiceGrant& grant, Instant at) {
    for (const Station& station : facts_.stations) {
      if (station.id != grant.station) continue;
      const bool is_early = grant.starts < instant(station.available_from);
      const bool is_late =
          station.available_until && grant.ready > instant(*station.available_until);
      if (!is_early && !is_late) continue;
      report("L27", at,
             fmt::format("bay {} of station {} given to {} from {:.1f} to {:.1f} s, {} its hours",
                         grant.bay, number(station.id), text(node(grant.agent)),
                         seconds(grant.starts).base(), seconds(grant.ready).base(),
                         is_early ? "before" : "after"));
    }
  }

  void check_bay(const Books& books, const ServiceGrant& grant, Instant at) {
    const auto holder = books.holders.find(grant.bay);
    if (holder == books.holders.end() || holder->second.released) return;
    const auto claim = books.claims.find(holder->second.grant.agent);
    const bool is_expired =
        claim == books.claims.end() || claim->second.last_heard + facts_.claim_lease <= at;
    if (!is_expired) {
      report("L9", at,
             fmt::format("bay {} of station {} given to {} while {} holds it", grant.bay,
                         number(grant.station), text(node(grant.agent)),
                         text(node(holder->second.grant.agent))));
    }
  }

  static bool is_served(const Books& books, AgentId agent, std::uint64_t claim) {
    return std::any_of(books.holders.begin(), books.holders.end(), [&](const auto& bay) {
      return bay.second.grant.agent == agent && bay.second.grant.claim == claim;
    });
  }

  void check_turn(const Books& books, const ServiceGrant& grant, Instant at) {
    const auto own = books.claims.find(grant.agent);
    if (own == books.claims.end() || own->second.last.claim != grant.claim) {
      report("L11", at,
             fmt::format("station {} served {}, which did not ask", number(grant.station),
                         text(node(grant.agent))));
      return;
    }
    for (const auto& [agent, claim] : books.claims) {
      const bool is_waiting = claim.last.status == ClaimStatus::waiting &&
                              claim.first_heard + grace <= at &&
                              claim.last_heard + facts_.claim_lease > at;
      if (books.refused.contains({agent, claim.last.claim})) continue;
      if (is_served(books, agent, claim.last.claim)) continue;  // and has not heard of it yet
      const bool is_earlier = std::pair{claim.last.first_claimed, agent} <
                              std::pair{own->second.last.first_claimed, grant.agent};
      if (is_waiting && is_earlier) {
        report("L11", at,
               fmt::format("{} was served before {}, which came first", text(node(grant.agent)),
                           text(node(agent))));
      }
    }
  }

  void observe_state(const StationState& state, Instant at) {
    Books& books = books_[state.station];
    for (const BayState& bay : state.bays) {
      if (!bay.occupied) continue;
      const auto claim = books.claims.find(bay.agent);
      if (claim != books.claims.end() &&
          claim->second.last_heard + facts_.claim_lease + grace < at) {
        report("L10", at,
               fmt::format("bay {} of station {} is held by {}, silent since {:.1f} s", bay.bay,
                           number(state.station), text(node(bay.agent)),
                           seconds(claim->second.last_heard).base()));
      }
    }
    if (state.swaps > books.swaps || state.filled.base() > books.filled_l + 1e-6 ||
        state.swaps < books.last.swaps || state.filled < books.last.filled) {
      report("L12", at,
             fmt::format("station {} counts {} swaps and {:.2f} l, its grants {} and {:.2f} l",
                         number(state.station), state.swaps, state.filled.base(), books.swaps,
                         books.filled_l));
    }
    books.last = state;
  }

  const Facts& facts_;
  std::map<AgentId, Volume> tanks_;
  std::map<StationId, Books> books_;
};

}  // namespace

std::unique_ptr<Checker> station_laws(const Facts& facts) {
  return std::make_unique<StationLaws>(facts);
}

}  // namespace furrow::sim
