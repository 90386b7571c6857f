#include "transport/granted_director.hpp"

#include "transport/fleet_topics.hpp"
#include "transport/granted_clock.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <thread>

#include <spdlog/spdlog.h>

namespace furrow::transport {
namespace {

using std::chrono::milliseconds;
using WallClock = std::chrono::steady_clock;
using Result = Expected<DirectorResult, TransportError>;
using fleet::v1::TimeGrant;
using fleet::v1::TimeRequest;

constexpr milliseconds slice{20};

struct Stop {
  Ending ending;
  Instant end;
};

class GrantedDirector {
 public:
  GrantedDirector(const DirectorSettings& settings, Participant& participant, Incoming& incoming)
      : settings_{settings},
        incoming_{incoming},
        watch_{settings, incoming},
        recorder_{settings},
        clock_{settings.members, settings.latency},
        topics_{participant,
                role::director,
                true,
                TimeMode::granted,
                BootId{1},
                [this](Origin origin, std::size_t topic, std::optional<Envelope> envelope) {
                  incoming_.put(origin, topic, std::move(envelope));
                }} {
    for (const MemberPlan& member : settings.members) {
      grants_[member.participant] =
          participant.writer<TimeGrant>("time_grant/" + std::to_string(member.participant),
                                        "fleet::v1::TimeGrant", clock_quality);
    }
    participant.reader<TimeRequest>("time_request", "fleet::v1::TimeRequest", clock_quality,
                                    [this](Origin origin, Received<TimeRequest>& received) {
                                      const bool is_own =
                                          received.sample.member() == origin.participant;
                                      if (received.malformed || !is_own) return incoming_.reject();
                                      incoming_.note(received.sample);
                                    });
  }

  Result run() {
    if (const auto failure = gather()) {
      if (is_called_off_) return end({Ending::interrupted, Instant{}});
      return Unexpected{*failure};
    }
    began_ = WallClock::now();
    for (;;) {
      speak();
      if (const auto stop = stop_before_round()) return end(*stop);
      pace();
      begin_round();
      if (const auto failure = await_round()) return end({Ending::failed, reached_}, failure->what);
      if (const auto finished = record_round()) return end({Ending::finished, *finished});
    }
  }

 private:
  // --- start ---

  // Every end of every topic must have found all its counterparts, on both sides.
  bool is_complete(const MemberPlan& member, const TimeRequest& hello) const {
    const Kinds hosted = kinds_of(member.nodes);
    std::size_t endpoints = 0;
    for (const auto& count : hello.matches()) {
      if (count.topic() >= topic_count) return false;
      const TopicContract& c = contract[count.topic()];
      const bool with_director = count.is_writer() != ((c.writers & role::director) != 0);
      const std::uint32_t others = members_that(count.is_writer() ? c.readers : c.writers);
      if (count.matched() != others + with_director) return false;
      ++endpoints;
    }
    std::size_t expected = 0;
    for (const TopicContract& c : contract) {
      expected += ((c.writers & hosted) != 0) + ((c.readers & hosted) != 0);
    }
    return endpoints == expected;
  }

  bool is_recorder_complete() const {
    const auto matches = topics_.matches();
    return std::all_of(matches.begin(), matches.end(), [&](const auto& count) {
      const TopicContract& c = contract[count.topic()];
      return count.matched() == members_that(count.is_writer() ? c.readers : c.writers);
    });
  }

  std::uint32_t members_that(Kinds kinds) const {
    return static_cast<std::uint32_t>(
        std::count_if(settings_.members.begin(), settings_.members.end(),
                      [&](const MemberPlan& m) { return (kinds_of(m.nodes) & kinds) != 0; }));
  }

  std::optional<TransportError> gather() {
    const auto end = WallClock::now() + settings_.start_timeout;
    for (;;) {
      for (TimeRequest& hello : incoming_.take_notes(1, slice)) {
        hellos_[hello.member()] = std::move(hello);
      }
      const auto missing = who_is_missing();
      if (!missing && is_recorder_complete()) break;
      for (const std::uint32_t dead : watch_.new_deaths()) {
        return TransportError{text(plan(dead)) + " ended before the start"};
      }
      is_called_off_ = watch_.is_interrupted();
      if (is_called_off_) return TransportError{"interrupted before the start"};
      if (WallClock::now() > end) {
        return TransportError{missing.value_or("the recorder does not hear every member") +
                              " within " + std::to_string(settings_.start_timeout.count() / 1000) +
                              " s"};
      }
    }
    for (const MemberPlan& member : settings_.members) {
      const std::int64_t next_ns = hellos_[member.participant].next_event_ns();
      clock_.report(member.participant, Instant{Duration{next_ns}});
    }
    return std::nullopt;
  }

  // Those who have not come at all before those who only wait for them.
  std::optional<std::string> who_is_missing() {
    for (const MemberPlan& member : settings_.members) {
      if (!hellos_.contains(member.participant)) return text(member) + " did not come";
    }
    for (const MemberPlan& member : settings_.members) {
      const bool is_heard = grants_[member.participant].matched() > 0;
      if (!is_heard || !is_complete(member, hellos_[member.participant])) {
        return text(member) + " does not hear all of the others";
      }
    }
    return std::nullopt;
  }

  const MemberPlan& plan(std::uint32_t participant) const {
    return *std::find_if(settings_.members.begin(), settings_.members.end(),
                         [&](const MemberPlan& m) { return m.participant == participant; });
  }

  // --- rounds ---

  std::optional<Stop> stop_before_round() {
    bury();
    if (!watch_.has_anyone()) return Stop{Ending::abandoned, reached_};
    if (watch_.is_interrupted()) return Stop{Ending::interrupted, reached_};
    const Instant next = clock_.next_event();
    if (next == never) return Stop{Ending::idle, reached_};
    if (next > settings_.mission_limit) return Stop{Ending::mission_limit, settings_.mission_limit};
    return std::nullopt;
  }

  void bury() {
    for (const std::uint32_t dead : watch_.new_deaths()) {
      spdlog::warn("{} has died; the run goes on without it", text(plan(dead)));
      clock_.drop(dead);
    }
  }

  // Its own words are sent at the end of what was granted: nobody has been beyond that.
  void speak() {
    for (Envelope& word : recorder_.own_words(reached_)) {
      const std::size_t topic = word.body.index();
      const std::uint64_t sequence = topics_.publish(word);
      if (sequence == 0) continue;
      clock_.sent(director_participant, topic, sequence, word);
      recorder_.keep(std::move(word));
    }
  }

  // When the next event is due in real time.
  WallClock::time_point due() const {
    const double wall_s = seconds(clock_.next_event()).base() / *settings_.pace;
    return began_ +
           std::chrono::duration_cast<WallClock::duration>(std::chrono::duration<double>{wall_s});
  }

  void pace() {
    if (!settings_.pace) return;
    while (WallClock::now() < due() && !(settings_.interrupted && settings_.interrupted())) {
      std::this_thread::sleep_until(std::min(due(), WallClock::now() + slice));
      speak();
    }
  }

  void begin_round() {
    const Instant last =
        settings_.mission_limit == never ? never : settings_.mission_limit + Duration{1};
    const GrantedClock::Round round = clock_.next_round(last);
    ++round_;
    round_end_ = round.limit - Duration{1};
    for (const auto& given : round.grants) {
      TimeGrant grant;
      grant.member(given.participant);
      grant.round(round_);
      grant.limit_ns(round.limit.time_since_epoch().count());
      for (const auto& [source, sequence] : given.needed) {
        auto& needed = grant.needed().emplace_back();
        needed.member(source.first);
        needed.topic(static_cast<std::uint8_t>(source.second));
        needed.last_sequence(sequence);
      }
      awaited_.insert(given.participant);
      grants_[given.participant].write(grant);
    }
  }

  // Until every granted member has reported, and all that it has sent is here.
  std::optional<TransportError> await_round() {
    const auto end = WallClock::now() + settings_.stall_timeout;
    while (!awaited_.empty()) {
      for (TimeRequest& request : incoming_.take_notes(awaited_.size(), slice)) {
        const bool is_due = request.round() == round_ && awaited_.contains(request.member());
        if (!is_due) continue;
        if (!hold(request)) {
          return TransportError{"messages of " + text(plan(request.member())) + " are missing"};
        }
        awaited_.erase(request.member());
        reports_[request.member()] = Instant{Duration{request.next_event_ns()}};
      }
      if (awaited_.empty()) break;
      bury();
      std::erase_if(awaited_, [&](std::uint32_t m) { return watch_.died().contains(m); });
      if (WallClock::now() > end) {
        return TransportError{text(plan(*awaited_.begin())) + " does not answer"};
      }
    }
    return std::nullopt;
  }

  bool hold(TimeRequest& request) {
    const auto end = WallClock::now() + settings_.stall_timeout;
    for (auto& written : request.written()) {
      while (
          !incoming_.wait_for(request.member(), written.topic(), written.last_sequence(), slice)) {
        if (incoming_.has_lost(request.member())) break;  // nobody else can repeat it
        if (WallClock::now() > end) return false;
      }
    }
    return true;
  }

  // @return  When the scheduler said that it has finished, if it did.
  std::optional<Instant> record_round() {
    std::vector<Sample> samples = incoming_.take_messages();
    std::sort(samples.begin(), samples.end(),
              [](const Sample& a, const Sample& b) { return is_earlier(a.envelope, b.envelope); });
    for (const Sample& s : samples) {
      clock_.sent(s.origin.participant, s.topic, s.origin.sequence, s.envelope);
    }
    for (const auto& [participant, next] : reports_) clock_.report(participant, next);
    reports_.clear();
    reached_ = round_end_;

    std::optional<Instant> finished;
    for (Sample& s : samples) {
      if (finished && s.envelope.sent > *finished) break;
      if (!finished && ends_mission(s.envelope)) finished = s.envelope.sent;
      recorder_.keep(std::move(s.envelope));
    }
    return finished;
  }

  Result end(Stop stop, std::string reason = {}) {
    for (auto& [participant, writer] : grants_) {
      TimeGrant grant;
      grant.member(participant);
      grant.round(round_ + 1);
      grant.stop(true);
      writer.write(grant);
    }
    for (auto& [participant, writer] : grants_) {
      if (!watch_.died().contains(participant)) {
        writer.wait_for_acknowledgements(milliseconds{2000});
      }
    }
    DirectorResult result = std::move(recorder_).result(stop.ending, stop.end, watch_.died(),
                                                        round_, incoming_.malformed());
    result.reason = std::move(reason);
    return result;
  }

  const DirectorSettings& settings_;
  Incoming& incoming_;
  Watch watch_;
  Recorder recorder_;
  GrantedClock clock_;
  FleetTopics topics_;
  std::map<std::uint32_t, Writer<TimeGrant>> grants_;
  std::map<std::uint32_t, TimeRequest> hellos_;
  std::set<std::uint32_t> awaited_;
  std::map<std::uint32_t, Instant> reports_;
  std::uint64_t round_ = 0;
  Instant round_end_{}, reached_{};  // of the round on its way, and of what is recorded
  bool is_called_off_ = false;
  WallClock::time_point began_;
};

}  // namespace

Expected<DirectorResult, TransportError> run_granted_director(const DirectorSettings& settings,
                                                              Participant& participant,
                                                              Incoming& incoming) {
  GrantedDirector director{settings, participant, incoming};
  auto result = director.run();
  participant.close();  // no listener may call into the director after this
  return result;
}

}  // namespace furrow::transport
