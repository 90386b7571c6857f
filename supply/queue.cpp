#include "supply/queue.hpp"

#include "core/require.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace furrow::supply {
namespace {

constexpr double worth_coupling = 0.01;  // of a tank: of a rest below that nobody is given

bool is_before(const Visit& a, const Visit& b) {
  return std::tie(a.first_claimed, a.agent) < std::tie(b.first_claimed, b.agent);
}

bool is_sound(const ServiceClaim& claim) {
  return claim.claim > 0 && claim.fill >= 0.0 && claim.fill <= 1.0;  // false for NaN too
}

}  // namespace

BayQueue::BayQueue(const Station& station, LeaseTerms terms, std::map<AgentId, Volume> tanks)
    : station_{station}, terms_{terms}, tanks_{std::move(tanks)} {
  require(station.bays >= 1, "a station has a bay");
  require(terms.lease > Duration::zero() && terms.clearing >= Duration::zero(),
          "a lease lasts and clearing a bay takes no negative time");
}

Visit* BayQueue::visit_of(AgentId agent) {
  const auto it = std::find_if(visits_.begin(), visits_.end(),
                               [agent](const Visit& v) { return v.agent == agent; });
  return it == visits_.end() ? nullptr : &*it;
}

/// Whether the claim is of the agent's present incarnation and of a visit that is not over.
bool BayQueue::is_present(const ServiceClaim& claim) {
  Past& past = past_.try_emplace(claim.agent, Past{.boot = claim.boot}).first->second;
  if (past.boot != claim.boot) {
    const bool is_retired = std::count(past.retired.begin(), past.retired.end(), claim.boot) > 0;
    // While the bay of the earlier incarnation is not cleared, the aircraft may still stand in it.
    if (is_retired || visit_of(claim.agent) != nullptr) return false;
    past.retired.push_back(past.boot);
    past.boot = claim.boot;
    past.finished = 0;
  }
  return claim.claim > past.finished;
}

std::optional<Visit> BayQueue::hear(const ServiceClaim& claim, Instant now) {
  if (claim.station != station_.id || !is_sound(claim)) return std::nullopt;
  drop_expired(now);
  if (!is_present(claim)) return std::nullopt;
  Visit* visit = visit_of(claim.agent);
  if (visit != nullptr && claim.claim < visit->claim) return std::nullopt;
  if (visit != nullptr && claim.claim > visit->claim) {  // its release was lost
    finish(claim.agent, now);
    visit = nullptr;
  }
  if (visit == nullptr) visit = revive(claim, now);
  if (claim.status == ClaimStatus::released) {
    finish(claim.agent, now);
    past_.at(claim.agent).finished = claim.claim;
    return std::nullopt;
  }
  if (visit == nullptr) {
    const Visit fresh{.agent = claim.agent,
                      .boot = claim.boot,
                      .claim = claim.claim,
                      .first_claimed = claim.first_claimed,
                      .swap = claim.swap,
                      .fill = claim.fill,
                      .expires = now + terms_.lease,
                      .bay = 0,
                      .token = 0,
                      .starts = {},
                      .ready = {},
                      .gives_swap = false,
                      .gives_fill = 0.0,
                      .counted = false};
    ++changes_;
    return *visits_.insert(std::upper_bound(visits_.begin(), visits_.end(), fresh, is_before),
                           fresh);
  }
  visit->expires = now + terms_.lease;
  return *visit;
}

/// Takes up the visit of a holder that had fallen silent where it was left, in the same bay, while
/// nobody else has that.
Visit* BayQueue::revive(const ServiceClaim& claim, Instant now) {
  const auto found = lapsed_.find(claim.agent);
  if (found == lapsed_.end()) return nullptr;
  Visit visit = found->second;
  lapsed_.erase(found);
  if (visit.boot != claim.boot) return nullptr;
  count(visit, now);  // it was served in silence
  if (visit.claim != claim.claim || !is_free(visit.bay)) return nullptr;
  visit.expires = now + terms_.lease;
  ++changes_;
  return &*visits_.insert(std::upper_bound(visits_.begin(), visits_.end(), visit, is_before),
                          visit);
}

void BayQueue::count(Visit& visit, Instant now) {
  if (visit.bay == 0 || visit.counted || visit.ready > now) return;
  visit.counted = true;
  ++changes_;
  if (visit.gives_swap) ++handed_out_.swaps;
  handed_out_.tanks[visit.agent] += visit.gives_fill;
}

void BayQueue::finish(AgentId agent, Instant now) {
  Visit* visit = visit_of(agent);
  if (visit == nullptr) return;
  count(*visit, now);
  past_.at(agent).finished = visit->claim;
  visits_.erase(visits_.begin() + (visit - visits_.data()));
  ++changes_;
}

Instant BayQueue::dropped_at(const Visit& visit) const {
  return visit.bay == 0 ? visit.expires : visit.expires + terms_.clearing;
}

/// A visit dropped is not over: its agent may renew it late, and queues again in its old place.
void BayQueue::drop_expired(Instant now) {
  for (Visit& visit : visits_) {
    count(visit, now);
    if (visit.bay != 0 && dropped_at(visit) <= now) lapsed_.insert_or_assign(visit.agent, visit);
  }
  changes_ += std::erase_if(visits_, [&](const Visit& v) { return dropped_at(v) <= now; });
}

bool BayQueue::is_free(std::uint32_t bay) const {
  return std::none_of(visits_.begin(), visits_.end(),
                      [bay](const Visit& v) { return v.bay == bay; });
}

/// The lowest free bay, 0 when all are taken.
std::uint32_t BayQueue::free_bay() const {
  for (std::uint32_t bay = 1; bay <= station_.bays; ++bay) {
    if (is_free(bay) && !shut_.contains(bay)) return bay;
  }
  return 0;
}

HandedOut BayQueue::promised() const {
  HandedOut sum;
  const auto add = [&](const Visit& visit) {
    if (visit.counted) return;
    sum.swaps += visit.gives_swap;
    sum.tanks[visit.agent] += visit.gives_fill;
  };
  for (const Visit& visit : visits_) add(visit);
  for (const auto& [agent, visit] : lapsed_) add(visit);
  return sum;
}

Volume BayQueue::volume(const HandedOut& handed_out) const {
  Volume sum;
  for (const auto& [agent, share] : handed_out.tanks) {
    const auto tank = tanks_.find(agent);
    if (tank != tanks_.end()) sum += share * tank->second;
  }
  return sum;
}

Volume BayQueue::filled() const { return volume(handed_out_); }

bool BayQueue::has_pack() const {
  return !station_.packs || handed_out_.swaps + promised().swaps < *station_.packs;
}

/// What there is of the share of a tank wanted.
double BayQueue::fill_for(const Visit& visit) const {
  const auto tank = tanks_.find(visit.agent);
  if (!station_.mix || tank == tanks_.end()) return visit.fill;
  const Volume left = *station_.mix - filled() - volume(promised());
  const double there = left / tank->second, share = std::min(visit.fill, there);
  return share < worth_coupling && share < visit.fill ? 0.0 : share;
}

void BayQueue::shut(std::uint32_t bay) {
  require(bay >= 1 && bay <= station_.bays, "a station shuts bays of its own");
  shut_.insert(bay);
}

std::uint32_t BayQueue::open_bays() const {
  return station_.bays - static_cast<std::uint32_t>(shut_.size());
}

Duration BayQueue::service_of(const Visit& visit) const {
  return duration(service_time(station_, visit.swap && has_pack(), fill_for(visit)));
}

/// When its service begins at the latest; earlier than the station opens: never.
Instant BayQueue::last_begin(const Visit& visit) const {
  if (!station_.available_until) return never;
  const Instant last = instant(*station_.available_until) - service_of(visit);
  return last < instant(station_.available_from) ? Instant::min() : last;
}

bool BayQueue::lacks(const Visit& visit, Instant now) const {
  if (open_bays() == 0 || now > last_begin(visit)) return true;
  const bool wants = visit.swap || visit.fill > 0.0;
  return wants && !(visit.swap && has_pack()) && fill_for(visit) <= 0.0;
}

std::vector<Visit> BayQueue::advance(Instant now) {
  drop_expired(now);
  advanced_ = now;
  std::vector<Visit> served;
  if (now < instant(station_.available_from)) return served;
  for (Visit& visit : visits_) {
    if (visit.bay != 0 || lacks(visit, now)) continue;
    const std::uint32_t bay = free_bay();
    if (bay == 0) break;
    visit.gives_swap = visit.swap && has_pack();
    visit.gives_fill = fill_for(visit);
    visit.bay = bay;
    visit.token = ++last_token_;
    ++changes_;
    visit.starts = now;
    visit.ready = now + duration(service_time(station_, visit.gives_swap, visit.gives_fill));
    count(visit, now);
    served.push_back(visit);
  }
  return served;
}

/// When the station opens for one who waits, or is too late for it.
Instant BayQueue::next_change(const Visit& visit) const {
  const Instant opens = instant(station_.available_from), last = last_begin(visit);
  if (advanced_ < opens) return opens;
  return last == never || advanced_ > last ? never : last + Duration{1};
}

Instant BayQueue::next_event() const {
  Instant next = never;
  for (const Visit& visit : visits_) {
    next = std::min(next, dropped_at(visit));
    if (visit.bay == 0) next = std::min(next, next_change(visit));
    if (visit.bay != 0 && !visit.counted) next = std::min(next, visit.ready);
  }
  return next;
}

Instant BayQueue::next_free(Instant now) const {
  std::vector<Instant> free;
  for (std::uint32_t bay = 1; bay <= station_.bays; ++bay) {
    if (!shut_.contains(bay)) free.push_back(std::max(now, instant(station_.available_from)));
  }
  if (free.empty()) return Instant{};
  std::size_t taken = 0;
  for (const Visit& v : visits_) {
    if (v.bay != 0 && !shut_.contains(v.bay)) free[taken++] = std::max(now, v.ready);
  }
  for (const Visit& v : visits_) {
    if (v.bay != 0 || lacks(v, now)) continue;
    *std::min_element(free.begin(), free.end()) += duration(service_time(station_, v.swap, v.fill));
  }
  return *std::min_element(free.begin(), free.end());
}

std::vector<Visit> BayQueue::waiting() const {
  std::vector<Visit> found;
  std::copy_if(visits_.begin(), visits_.end(), std::back_inserter(found),
               [](const Visit& v) { return v.bay == 0; });
  return found;
}

std::vector<Visit> BayQueue::in_bay() const {
  std::vector<Visit> found;
  std::copy_if(visits_.begin(), visits_.end(), std::back_inserter(found),
               [](const Visit& v) { return v.bay != 0; });
  std::sort(found.begin(), found.end(),
            [](const Visit& a, const Visit& b) { return a.bay < b.bay; });
  return found;
}

}  // namespace furrow::supply
