#pragma once
// Who is served when at one station. Plain bookkeeping: the node around it speaks and listens.

#include "core/messages.hpp"
#include "core/station.hpp"
#include "core/time.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace furrow::supply {

/// How long the word of an aircraft counts.
struct LeaseTerms {
  Duration lease;  ///< A claim not renewed for longer is dropped; > 0.
  /// A bay whose holder fell silent stays shut for as long after that; >= 0.
  Duration clearing{std::chrono::seconds{1}};
};

/// One aircraft's visit, in the queue or in a bay.
struct Visit {
  AgentId agent;
  BootId boot;
  std::uint64_t claim;
  Instant first_claimed;
  bool swap;
  double fill;          ///< Share of a tank, 0 .. 1.
  Instant expires;      ///< Last renewal plus lease.
  std::uint32_t bay;    ///< 0 while waiting.
  std::uint64_t token;  ///< 0 while waiting, as the next two.
  Instant starts, ready;
  bool gives_swap;    ///< False while waiting.
  double gives_fill;  ///< Share of a tank; 0 while waiting.
  bool counted;       ///< Its service is in the totals.
};

/// What the station has handed out. Each service counts once, when it is done.
struct HandedOut {
  std::uint32_t swaps = 0;
  std::map<AgentId, double> tanks{};  ///< Shares of a tank, summed.
};

/// The bays of one station and the queue for them: first come first served, by the instant of the
/// first claim, then by agent id. Claims may be lost, repeated and reordered: a claim of an earlier
/// visit, of a finished one or of an earlier incarnation of an agent changes nothing. A holder that
/// is heard again after its bay was freed has it back with the same token while nobody else has it.
///
/// Services begin when the station is open and are done before it closes.
///
/// A stock of mix or packs may come to its end. The last of it is given to who is next, though it
/// is less than claimed; after that `lacks` tells whom the station cannot help, and they are passed
/// over. What a holder that fell silent was being given counts as gone.
///
/// First come counts among the claims that have arrived: a free bay is not kept for one that may
/// still be on its way.
class BayQueue {
 public:
  /// @param tanks  Of every aircraft that may come: what a share of a tank takes from the stock.
  BayQueue(const Station& station, LeaseTerms terms, std::map<AgentId, Volume> tanks = {});

  /// Takes a heartbeat of a visit; a release frees the bay at once.
  /// @return  The visit it belongs to, nothing for a claim that is over, stale or impossible.
  std::optional<Visit> hear(const ServiceClaim& claim, Instant now);

  /// Drops what has expired, counts the services done and fills free bays from the queue.
  /// @return  The visits that got a bay now, in order of service.
  std::vector<Visit> advance(Instant now);

  /// When `advance` has something to do next, later than the last `advance`; `never` without
  /// visits.
  Instant next_event() const;

  /// Gives this bay to nobody more; its holder keeps it. @pre 1 <= bay <= bays
  void shut(std::uint32_t bay);
  /// Bays that are not shut.
  std::uint32_t open_bays() const;

  /// Whether the station has nothing left of what a waiting visit wants, no bay for it, or closes
  /// before it can be served from `now` on.
  bool lacks(const Visit& visit, Instant now) const;

  /// When one who comes now is expected to have a bay, if all who wait or are served take as long
  /// as what they claim; 0 where all bays are shut. Time O(visits * bays).
  Instant next_free(Instant now) const;

  /// Visits without a bay, in order of service.
  std::vector<Visit> waiting() const;
  /// Visits in a bay, by bay.
  std::vector<Visit> in_bay() const;
  const HandedOut& handed_out() const { return handed_out_; }
  /// Mix handed out so far.
  Volume filled() const;
  /// Rises with every change of the queue, the bays or what was handed out; not with renewals.
  std::uint64_t changes() const { return changes_; }

 private:
  /// What is known of an agent beyond its present visit.
  struct Past {
    BootId boot;
    std::uint64_t finished = 0;     ///< Highest claim that is over.
    std::vector<BootId> retired{};  ///< Earlier incarnations.
  };

  /// What was promised to those in a bay, beyond what was handed out.
  HandedOut promised() const;
  Volume volume(const HandedOut& handed_out) const;
  bool has_pack() const;
  double fill_for(const Visit& visit) const;
  Duration service_of(const Visit& visit) const;
  Instant last_begin(const Visit& visit) const;
  Instant next_change(const Visit& visit) const;
  bool is_present(const ServiceClaim& claim);
  Visit* visit_of(AgentId agent);
  Visit* revive(const ServiceClaim& claim, Instant now);
  void finish(AgentId agent, Instant now);
  void count(Visit& visit, Instant now);
  void drop_expired(Instant now);
  Instant dropped_at(const Visit& visit) const;
  bool is_free(std::uint32_t bay) const;
  std::uint32_t free_bay() const;

  Station station_;
  LeaseTerms terms_;
  std::map<AgentId, Volume> tanks_;
  std::set<std::uint32_t> shut_;
  std::vector<Visit> visits_;  ///< Sorted by first claim, then agent.
  std::map<AgentId, Past> past_;
  std::map<AgentId, Visit> lapsed_;  ///< Holders dropped for their silence.
  HandedOut handed_out_;
  std::uint64_t last_token_ = 0;
  std::uint64_t changes_ = 0;
  Instant advanced_{};  ///< When it was last.
};

}  // namespace furrow::supply
