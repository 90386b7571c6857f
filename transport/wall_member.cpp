#include "transport/wall_member.hpp"

#include "transport/fleet_topics.hpp"
#include "transport/mailbox.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>

#include <spdlog/spdlog.h>

namespace furrow::transport {
namespace {

using std::chrono::milliseconds;

constexpr Duration grace{1'000'000'000};  // between the scheduler's farewell and ours
constexpr Duration longest_sleep = wall_lease / 4;

std::atomic<bool> is_told_to_stop{false};
static_assert(std::atomic<bool>::is_always_lock_free);

struct Nothing {};  // the clock says nothing on the wall clock

class WallMember {
 public:
  WallMember(const MemberSettings& settings, NodeHost host, Participant& participant,
             Mailbox<Nothing>& mailbox)
      : settings_{settings},
        host_{std::move(host)},
        mailbox_{mailbox},
        topics_{participant,
                kinds_of(settings.nodes),
                false,
                TimeMode::wall,
                settings.boot,
                [this](Origin origin, std::size_t topic, std::optional<Envelope> envelope) {
                  if (origin.participant == settings_.participant) return;
                  mailbox_.put(origin, topic, std::move(envelope));
                }} {}

  void run() {
    while (!is_told_to_stop && now() < end_) {
      topics_.assert_alive();
      const Duration pause = idle();
      if (pause > Duration{}) {
        mailbox_.wait_for_message(std::chrono::ceil<milliseconds>(pause));
      }
      tell_losses();
      step();
    }
  }

 private:
  Instant now() const { return mission_now(*settings_.epoch_realtime_ns); }

  // How long nothing is going to happen here; not above zero: something is due.
  Duration idle() const {
    const Instant next = host_.next_event();
    return next - longest_sleep > now() ? longest_sleep : next - now();
  }

  void step() {
    const Instant limit = std::max(now(), reached_);
    for (Sample& sample : mailbox_.take_messages()) take(std::move(sample.envelope), limit);
    const std::vector<Envelope> sent = host_.advance(limit);
    reached_ = limit;
    for (const Envelope& envelope : sent) {
      if (topics_.publish(envelope) == 0) {
        spdlog::warn("{} of {} could not be sent", topic(envelope.body), text(envelope.from));
      }
      take(envelope, limit);
    }
  }

  // Clocks of hosts differ, and the host has been where the sender was not yet: a message counts as
  // sent when it can still arrive.
  void take(Envelope envelope, Instant limit) {
    if (ends_mission(envelope)) end_ = std::min(end_, limit + grace);
    envelope.sent = std::clamp(envelope.sent, reached_, limit);
    host_.deliver(envelope);
  }

  void tell_losses() {
    if (!settings_.peer_lost) return;
    for (const std::uint32_t participant : mailbox_.lost()) {
      if (told_lost_.insert(participant).second) settings_.peer_lost(participant);
    }
  }

  const MemberSettings& settings_;
  NodeHost host_;
  Mailbox<Nothing>& mailbox_;
  FleetTopics topics_;
  Instant reached_{};
  Instant end_ = never;
  std::set<std::uint32_t> told_lost_;
};

}  // namespace

Instant mission_now(std::int64_t epoch_realtime_ns) {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return Instant{Duration{std::chrono::nanoseconds{now}.count() - epoch_realtime_ns}};
}

Expected<std::monostate, TransportError> run_wall_member(const MemberSettings& settings,
                                                         NodeHost host) {
  std::signal(SIGTERM, [](int) { is_told_to_stop = true; });
  Mailbox<Nothing> mailbox;
  auto participant = Participant::join(settings.network, settings.participant, TimeMode::wall,
                                       [&](std::uint32_t lost) { mailbox.lose(lost); });
  if (!participant) return Unexpected{participant.error()};
  WallMember member{settings, std::move(host), **participant, mailbox};
  member.run();
  (*participant)->close();  // no listener may call into the member after this
  return std::monostate{};
}

}  // namespace furrow::transport
