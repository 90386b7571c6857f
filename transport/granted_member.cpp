#include "transport/granted_member.hpp"

#include "transport/fleet_topics.hpp"
#include "transport/mailbox.hpp"

#include <algorithm>
#include <chrono>
#include <optional>

namespace furrow::transport {
namespace {

using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;
using Done = std::monostate;
using End = Expected<Done, TransportError>;

constexpr milliseconds start_patience{60'000};
constexpr milliseconds sample_patience{20'000};
constexpr milliseconds slice{100};  // between looks at who is still there

class GrantedMember {
 public:
  GrantedMember(const MemberSettings& settings, NodeHost host, Participant& participant,
                Mailbox<fleet::v1::TimeGrant>& mailbox)
      : settings_{settings},
        host_{std::move(host)},
        mailbox_{mailbox},
        topics_{participant,
                kinds_of(settings.nodes),
                false,
                TimeMode::granted,
                settings.boot,
                [this](Origin origin, std::size_t topic, std::optional<Envelope> envelope) {
                  hear(origin, topic, std::move(envelope));
                }},
        requests_{participant.writer<fleet::v1::TimeRequest>(
            "time_request", "fleet::v1::TimeRequest", clock_quality)} {
    participant.reader<fleet::v1::TimeGrant>(
        "time_grant/" + std::to_string(settings.participant), "fleet::v1::TimeGrant", clock_quality,
        [this](Origin origin, Received<fleet::v1::TimeGrant>& received) {
          const bool is_ours = origin.participant == director_participant &&
                               received.sample.member() == settings_.participant;
          if (received.malformed || !is_ours) return mailbox_.reject();
          mailbox_.note(received.sample);
        });
  }

  End run() {
    auto grant = first_grant();
    while (grant) {
      if (grant->stop()) return Done{};
      round_ = grant->round();
      if (const auto missing = await_messages(*grant)) return Unexpected{*missing};
      if (const auto failure = step(Instant{Duration{grant->limit_ns()}})) {
        return Unexpected{*failure};
      }
      grant = next_grant();
    }
    if (round_ > 0) return Unexpected{TransportError{"the director is gone"}};
    if (mailbox_.has_lost(director_participant)) return Done{};  // it called the run off
    return Unexpected{TransportError{"no director came"}};
  }

 private:
  void hear(Origin origin, std::size_t topic, std::optional<Envelope> envelope) {
    if (origin.participant != settings_.participant) {
      mailbox_.put(origin, topic, std::move(envelope));
    }
  }

  // Says hello, again with every change of what it is matched with, until time is granted.
  std::optional<fleet::v1::TimeGrant> first_grant() {
    const auto end = Clock::now() + start_patience;
    std::vector<fleet::v1::MatchCount> told;
    auto told_at = Clock::time_point{};
    while (Clock::now() < end && !mailbox_.has_lost(director_participant)) {
      auto matches = topics_.matches();
      if (matches != told || Clock::now() - told_at > milliseconds{250}) {
        told = std::move(matches);
        told_at = Clock::now();
        request(told);
      }
      auto grants = mailbox_.take_notes(1, milliseconds{10});
      if (!grants.empty()) return std::move(grants.back());
    }
    return std::nullopt;
  }

  std::optional<fleet::v1::TimeGrant> next_grant() {
    for (;;) {
      // Asked before looking: what the director said last counts although it has left since.
      const bool is_alone = mailbox_.has_lost(director_participant);
      auto grants = mailbox_.take_notes(1, slice);
      for (auto& grant : grants) {
        if (grant.stop() || grant.round() > round_) return std::move(grant);
      }
      if (is_alone) return std::nullopt;
      tell_losses();
    }
  }

  void tell_losses() {
    if (!settings_.peer_lost) return;
    for (const std::uint32_t participant : mailbox_.lost()) {
      if (told_lost_.insert(participant).second) settings_.peer_lost(participant);
    }
  }

  // What a dead member sent and nobody else can repeat is not waited for.
  std::optional<TransportError> await_messages(fleet::v1::TimeGrant& grant) {
    const auto end = Clock::now() + sample_patience;
    for (auto& needed : grant.needed()) {
      while (!mailbox_.wait_for(needed.member(), needed.topic(), needed.last_sequence(), slice)) {
        if (mailbox_.has_lost(needed.member())) break;
        if (mailbox_.has_lost(director_participant)) {
          return TransportError{"the director is gone"};
        }
        if (Clock::now() > end) {
          return TransportError{"messages of participant " + std::to_string(needed.member()) +
                                " did not arrive"};
        }
      }
    }
    return std::nullopt;
  }

  std::optional<TransportError> step(Instant limit) {
    for (const Sample& sample : mailbox_.take_messages()) host_.deliver(sample.envelope);
    written_.clear();
    if (!advance(limit)) return TransportError{"a message could not be sent"};
    request({});
    return std::nullopt;
  }

  bool advance(Instant limit) {
    const std::vector<Envelope> sent = host_.advance(limit);
    for (const Envelope& envelope : sent) {
      const std::uint64_t sequence = topics_.publish(envelope);
      if (sequence == 0) return false;
      written_[envelope.body.index()] = sequence;
    }
    for (const Envelope& envelope : sent) host_.deliver(envelope);
    return true;
  }

  void request(const std::vector<fleet::v1::MatchCount>& matches) {
    fleet::v1::TimeRequest request;
    request.member(settings_.participant);
    request.round(round_);
    request.next_event_ns(host_.next_event().time_since_epoch().count());
    for (const auto& [topic, sequence] : written_) {
      auto& written = request.written().emplace_back();
      written.topic(static_cast<std::uint8_t>(topic));
      written.last_sequence(sequence);
    }
    request.matches(matches);
    requests_.write(request);
  }

  const MemberSettings& settings_;
  NodeHost host_;
  Mailbox<fleet::v1::TimeGrant>& mailbox_;
  FleetTopics topics_;
  Writer<fleet::v1::TimeRequest> requests_;
  std::uint64_t round_ = 0;
  std::map<std::size_t, std::uint64_t> written_;
  std::set<std::uint32_t> told_lost_;
};

}  // namespace

Expected<std::monostate, TransportError> run_granted_member(const MemberSettings& settings,
                                                            NodeHost host) {
  Mailbox<fleet::v1::TimeGrant> mailbox;
  auto participant = Participant::join(settings.network, settings.participant, TimeMode::granted,
                                       [&](std::uint32_t lost) { mailbox.lose(lost); });
  if (!participant) return Unexpected{participant.error()};
  GrantedMember member{settings, std::move(host), **participant, mailbox};
  const auto end = member.run();
  (*participant)->close();  // no listener may call into the member after this
  return end;
}

}  // namespace furrow::transport
