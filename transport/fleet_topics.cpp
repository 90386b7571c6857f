#include "transport/fleet_topics.hpp"

#include "core/require.hpp"

#include <utility>

namespace furrow::transport {
namespace {

// "agent_info" is of the type fleet::v1::AgentInfo.
std::string type_name(std::string_view topic) {
  std::string name = "fleet::v1::";
  bool capital = true;
  for (const char c : topic) {
    if (c != '_') name += capital ? static_cast<char>(c - 'a' + 'A') : c;
    capital = c == '_';
  }
  return name;
}

}  // namespace

Kinds kinds_of(const std::vector<NodeId>& nodes) {
  Kinds all = role::none;
  for (const NodeId id : nodes) all |= kinds(id.kind);
  return all;
}

struct FleetTopics::Out {
  virtual ~Out() = default;
  virtual std::uint64_t publish(const Envelope& envelope, BootId boot) = 0;
  virtual std::uint32_t matched() const = 0;
  virtual void assert_alive() = 0;
};

template <std::size_t topic>
struct FleetTopics::OutOf final : Out {
  Writer<WireType<topic>> writer;
  bool leased;

  OutOf(Writer<WireType<topic>> w, bool is_leased) : writer{w}, leased{is_leased} {}
  std::uint64_t publish(const Envelope& envelope, BootId boot) override {
    auto sample = encoded<topic>(envelope, boot);
    return writer.write(sample);
  }
  std::uint32_t matched() const override { return writer.matched(); }
  void assert_alive() override {
    if (leased) writer.assert_alive();
  }
};

struct FleetTopics::In {
  virtual ~In() = default;
  virtual std::uint32_t matched() const = 0;
};

template <std::size_t topic>
struct FleetTopics::InOf final : In {
  Reader<WireType<topic>>& reader;
  explicit InOf(Reader<WireType<topic>>& r) : reader{r} {}
  std::uint32_t matched() const override { return reader.matched(); }
};

template <std::size_t topic>
void FleetTopics::open(Participant& participant, Kinds hosted, bool listens_to_all, TimeMode mode,
                       const Heard& heard) {
  const TopicContract& c = contract[topic];
  const std::string name{c.name};
  const Quality q = quality(topic, mode);
  if (c.writers & hosted) {
    out_[topic] = std::make_unique<OutOf<topic>>(
        participant.writer<WireType<topic>>(name, type_name(name), q), q.lease.has_value());
  }
  const bool overhears = listens_to_all && !(c.writers & hosted);
  if (overhears || (c.readers & hosted)) {
    auto taken = [heard](Origin origin, Received<WireType<topic>>& received) {
      heard(origin, topic, received.malformed ? std::nullopt : decoded<topic>(received.sample));
    };
    in_[topic] = std::make_unique<InOf<topic>>(
        participant.reader<WireType<topic>>(name, type_name(name), q, std::move(taken)));
  }
}

FleetTopics::FleetTopics(Participant& participant, Kinds hosted, bool listens_to_all, TimeMode mode,
                         BootId boot, Heard heard)
    : boot_{boot} {
  [&]<std::size_t... topic>(std::index_sequence<topic...>) {
    (open<topic>(participant, hosted, listens_to_all, mode, heard), ...);
  }
  (std::make_index_sequence<topic_count>{});
}

FleetTopics::~FleetTopics() = default;

std::uint64_t FleetTopics::publish(const Envelope& envelope) {
  const auto& out = out_[envelope.body.index()];
  require(out != nullptr, "a node sends only what the contract lets its kind write");
  return out->publish(envelope, boot_);
}

std::vector<fleet::v1::MatchCount> FleetTopics::matches() const {
  std::vector<fleet::v1::MatchCount> counts;
  const auto add = [&](std::size_t topic, bool is_writer, std::uint32_t matched) {
    fleet::v1::MatchCount& count = counts.emplace_back();
    count.topic(static_cast<std::uint8_t>(topic));
    count.is_writer(is_writer);
    count.matched(matched);
  };
  for (std::size_t topic = 0; topic < topic_count; ++topic) {
    if (out_[topic]) add(topic, true, out_[topic]->matched());
    if (in_[topic]) add(topic, false, in_[topic]->matched());
  }
  return counts;
}

void FleetTopics::assert_alive() {
  for (const auto& out : out_) {
    if (out) out->assert_alive();
  }
}

}  // namespace furrow::transport
