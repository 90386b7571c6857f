// What the contract promises between two participants. Each has its own sockets, as a process has.
#include "transport/domain_lock.hpp"
#include "transport/fleet_topics.hpp"
#include "transport/mailbox.hpp"

#include <catch2/catch.hpp>

#include <set>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace furrow {
namespace {

using namespace transport;
using std::chrono::milliseconds;

struct Note {};

// A participant that hosts nodes of some kinds and keeps what it hears.
struct Post {
  Mailbox<Note> mailbox;
  std::unique_ptr<Participant> participant;
  std::unique_ptr<FleetTopics> topics;
  std::vector<Envelope> heard;

  Post(const Network& network, std::uint32_t number, Kinds hosted, TimeMode mode = TimeMode::wall) {
    auto joined = Participant::join(network, number, mode,
                                    [this](std::uint32_t lost) { mailbox.lose(lost); });
    require(joined.has_value(), "the test's ports are free");
    participant = std::move(*joined);
    topics = std::make_unique<FleetTopics>(
        *participant, hosted, false, mode, BootId{1},
        [this](Origin origin, std::size_t topic, std::optional<Envelope> e) {
          mailbox.put(origin, topic, std::move(e));
        });
  }
  ~Post() { participant->close(); }

  // Listens until `count` messages are there, for at most ten seconds.
  bool hears(std::size_t count, milliseconds patience = milliseconds{10'000}) {
    const auto end = std::chrono::steady_clock::now() + patience;
    while (heard.size() < count && std::chrono::steady_clock::now() < end) {
      mailbox.wait_for_message(milliseconds{20});
      for (Sample& s : mailbox.take_messages()) heard.push_back(std::move(s.envelope));
    }
    return heard.size() >= count;
  }
};

Network network(const DomainLock& lock, std::string run = "delivery") {
  return {.domain = lock.domain(), .run = std::move(run), .stations = 0};
}

DomainLock free_domain() {
  auto lock = DomainLock::any_free();
  require(lock.has_value(), "a domain is free");
  return std::move(*lock);
}

Envelope state_of(std::uint32_t agent) {
  AgentState state{};
  state.agent = AgentId{agent};
  return {node(AgentId{agent}), 1, Instant{}, state};
}

TEST_CASE("delivery: two hundred instances of a topic are all seen", "[transport]") {
  const DomainLock lock = free_domain();
  for (const TimeMode mode : {TimeMode::wall, TimeMode::granted}) {
    Post scheduler{network(lock), scheduler_participant, role::scheduler, mode};
    Post agents{network(lock), 2, role::agents, mode};
    for (std::uint32_t agent = 1; agent <= 200; ++agent) {
      REQUIRE(agents.topics->publish(state_of(agent)) == agent);
    }
    CHECK(scheduler.hears(200));
    std::set<NodeId> seen;
    for (const Envelope& e : scheduler.heard) seen.insert(e.from);
    CHECK(seen.size() == 200);
  }
}

TEST_CASE("delivery: a late joiner gets its whole command, and only the newest", "[transport]") {
  const DomainLock lock = free_domain();
  Post scheduler{network(lock), scheduler_participant, role::scheduler};
  Command command{};
  command.agent = AgentId{7};
  // 40 sorties of 500 pieces of 56 bytes: far more than a datagram holds.
  command.sorties.assign(40, {.pieces = std::vector<Piece>(500), .station = StationId{1}});
  for (std::uint32_t revision = 1; revision <= 3; ++revision) {
    command.revision = revision;
    REQUIRE(scheduler.topics->publish({scheduler_node(), revision, Instant{}, command}) > 0);
  }

  Post agent{network(lock), 2, role::agents};
  REQUIRE(agent.hears(1));
  CHECK_FALSE(agent.hears(2, milliseconds{200}));
  const auto& got = std::get<Command>(agent.heard[0].body);
  CHECK(got.revision == 3);
  REQUIRE(got.sorties.size() == 40);
  CHECK(got.sorties.back().pieces.size() == 500);
}

TEST_CASE("delivery: two runs on one host do not mix", "[transport]") {
  SECTION("they take different domains") {
    const DomainLock one = free_domain();
    const DomainLock other = free_domain();
    CHECK(one.domain() != other.domain());
  }
  SECTION("and even in one domain hear their own only") {
    const DomainLock lock = free_domain();
    Post scheduler{network(lock, "one"), scheduler_participant, role::scheduler};
    Post ours{network(lock, "one"), 2, role::agents};
    Post theirs{network(lock, "other"), 3, role::agents};
    scheduler.topics->publish({scheduler_node(), 1, Instant{},
                               SchedulerState{.epoch = Epoch{1},
                                              .phase = MissionPhase::flying,
                                              .completed = false,
                                              .sprayed_cells = 0,
                                              .open_cells = 0,
                                              .abandoned_cells = 0,
                                              .lost = {}}});
    CHECK(ours.hears(1));
    CHECK_FALSE(theirs.hears(1, milliseconds{500}));
  }
}

TEST_CASE("participant: refuses a number or a port that is taken", "[transport]") {
  const DomainLock lock = free_domain();
  const auto join = [&] {
    return Participant::join(network(lock), scheduler_participant, TimeMode::wall, {});
  };
  SECTION("by another participant of a fleet") {
    const auto first = join();
    REQUIRE(first);
    const auto second = join();
    REQUIRE_FALSE(second);
    CHECK(second.error().what ==
          "participant 1 of domain " + std::to_string(lock.domain()) + " runs already");
  }
  SECTION("by anybody else") {
    // 7400 + 250 d + 10 + 2 p: the discovery port of participant 1.
    const auto port = static_cast<std::uint16_t>(7412 + 250 * lock.domain());
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const int fd = ::socket(AF_INET, SOCK_DGRAM, 0);
    REQUIRE(::bind(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0);
    const auto refused = join();
    ::close(fd);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().what.find("UDP port " + std::to_string(port)) == 0);
  }
  SECTION("and an address that is none") {
    Network wrong = network(lock);
    wrong.interface = "eth0";
    const auto refused = Participant::join(wrong, 1, TimeMode::wall, {});
    REQUIRE_FALSE(refused);
    CHECK(refused.error().what == "interface `eth0` is not an IPv4 address");
  }
}

}  // namespace
}  // namespace furrow
