#include "transport/participant.hpp"

#include "core/require.hpp"
#include "transport/fastdds_log.hpp"
#include "transport/ports.hpp"

#include <array>
#include <cstdlib>
#include <random>

#include <arpa/inet.h>

#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>

namespace furrow::transport {
namespace {

namespace rtps = eprosima::fastrtps::rtps;
using eprosima::fastdds::rtps::UDPv4TransportDescriptor;

constexpr std::size_t number_at = 8;  // its place in the GUID prefix

// Vendor, a nonce for this start, and the number: every handle tells which participant it is of.
rtps::GuidPrefix_t prefix(std::uint32_t number) {
  rtps::GuidPrefix_t prefix;
  prefix.value[0] = 0x01;
  prefix.value[1] = 0x0f;
  std::random_device device;
  for (std::size_t i = 2; i < number_at; ++i) prefix.value[i] = static_cast<rtps::octet>(device());
  for (std::size_t i = 0; i < 4; ++i) {
    prefix.value[number_at + i] = static_cast<rtps::octet>(number >> (24 - 8 * i));
  }
  return prefix;
}

rtps::Locator_t locator(const std::string& address, std::uint32_t port) {
  rtps::Locator_t locator;
  rtps::IPLocator::createLocator(LOCATOR_KIND_UDPv4, address, port, locator);
  return locator;
}

eprosima::fastrtps::Duration_t dds_time(std::chrono::milliseconds t) {
  return {static_cast<std::int32_t>(t.count() / 1000),
          static_cast<std::uint32_t>(t.count() % 1000) * 1'000'000u};
}

// The star: everyone announces to the director, the scheduler and the stations only.
rtps::LocatorList_t star(const Network& network, std::uint32_t number) {
  rtps::LocatorList_t list;
  const std::uint32_t centres = first_agent_participant(network);
  for (std::uint32_t centre = 0; centre < centres; ++centre) {
    const std::uint32_t port = discovery_port(network.domain, centre);
    if (centre != number) list.push_back(locator(network.interface, port));
    for (const auto& peer : network.peers) list.push_back(locator(peer, port));
  }
  return list;
}

dds::DomainParticipantQos participant_qos(const Network& network, std::uint32_t number,
                                          TimeMode mode) {
  dds::DomainParticipantQos qos;
  qos.name(("furrow-" + std::to_string(number)).c_str());

  auto udp = std::make_shared<UDPv4TransportDescriptor>();
  udp->interfaceWhiteList = {network.interface};
  udp->sendBufferSize = udp->receiveBufferSize = 4u << 20;
  qos.transport().use_builtin_transports = false;  // neither shared memory nor multicast
  qos.transport().user_transports = {udp};

  auto& wire = qos.wire_protocol();
  wire.prefix = prefix(number);
  wire.participant_id = static_cast<std::int32_t>(number);
  wire.builtin.metatrafficUnicastLocatorList.push_back(
      locator(network.interface, discovery_port(network.domain, number)));
  wire.default_unicast_locator_list.push_back(
      locator(network.interface, user_port(network.domain, number)));
  wire.builtin.initialPeersList = star(network, number);
  wire.builtin.mutation_tries = 1000;

  // In granted time the launcher knows of deaths at once, and a false alarm would spoil the run.
  const bool wall = mode == TimeMode::wall;
  auto& discovery = wire.builtin.discovery_config;
  discovery.leaseDuration = wall ? dds_time(wall_lease) : dds_time(std::chrono::seconds{4});
  discovery.leaseDuration_announcementperiod = dds_time(std::chrono::milliseconds{300});
  discovery.initial_announcements.count = 20;
  discovery.initial_announcements.period = dds_time(std::chrono::milliseconds{50});
  return qos;
}

// What a writer offers and what a reader asks for are the same.
template <class Qos>
void apply(const Quality& quality, Qos& qos) {
  const auto [depth, keep_all] = quality.history;
  qos.reliability().kind = dds::RELIABLE_RELIABILITY_QOS;
  qos.reliability().max_blocking_time = dds_time(std::chrono::milliseconds{500});
  qos.durability().kind = dds::TRANSIENT_LOCAL_DURABILITY_QOS;
  qos.history().kind = keep_all ? dds::KEEP_ALL_HISTORY_QOS : dds::KEEP_LAST_HISTORY_QOS;
  qos.history().depth = depth;
  qos.resource_limits().max_instances = 0;  // 0: no limit
  qos.resource_limits().max_samples = 0;
  qos.resource_limits().max_samples_per_instance = depth;
  qos.resource_limits().allocated_samples = 0;
  qos.endpoint().history_memory_policy = rtps::DYNAMIC_REUSABLE_MEMORY_MODE;
  qos.data_sharing().off();
  if (quality.lease) {
    qos.liveliness().kind = dds::MANUAL_BY_TOPIC_LIVELINESS_QOS;
    qos.liveliness().lease_duration = dds_time(*quality.lease);
    qos.liveliness().announcement_period = dds_time(*quality.lease / 3);
  }
}

// A stray profile or variable of the environment must not change how a run talks.
void ignore_environment() {
  ::setenv("SKIP_DEFAULT_XML_FILE", "1", 1);
  ::unsetenv("FASTRTPS_DEFAULT_PROFILES_FILE");
  ::unsetenv("FASTDDS_ENVIRONMENT_FILE");
  ::unsetenv("FASTDDS_STATISTICS");
  ::unsetenv("ROS_DISCOVERY_SERVER");
}

std::optional<TransportError> refusal(const Network& network, std::uint32_t number) {
  in_addr ignored{};
  if (network.domain > max_domain) {
    return TransportError{"domain " + std::to_string(network.domain) + " is not in 0 .. 100"};
  }
  if (number > max_participant) {
    return TransportError{"participant " + std::to_string(number) +
                          " is not in 0 .. 119: host several agents in one process"};
  }
  if (::inet_pton(AF_INET, network.interface.c_str(), &ignored) != 1) {
    return TransportError{"interface `" + network.interface + "` is not an IPv4 address"};
  }
  for (const std::uint32_t port :
       {discovery_port(network.domain, number), user_port(network.domain, number)}) {
    if (!is_port_free(network.interface, port)) {
      return TransportError{"UDP port " + std::to_string(port) + " of " + network.interface +
                            " is taken or cannot be bound: participant " + std::to_string(number) +
                            " of domain " + std::to_string(network.domain) + " cannot start"};
    }
  }
  return std::nullopt;
}

}  // namespace

std::uint32_t participant_of(const rtps::GuidPrefix_t& prefix) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) number = number << 8 | prefix.value[number_at + i];
  return number;
}

void Participant::Listener::on_participant_discovery(dds::DomainParticipant*,
                                                     rtps::ParticipantDiscoveryInfo&& info) {
  using Info = rtps::ParticipantDiscoveryInfo;
  if (info.status == Info::REMOVED_PARTICIPANT || info.status == Info::DROPPED_PARTICIPANT) {
    vigil.lose(participant_of(info.info.m_guid.guidPrefix));
  }
}

Participant::Participant(NameLock lock, PeerLost lost)
    : lock_{std::move(lock)},
      vigil_{std::move(lost), wall_lease - suspicion_lease},
      listener_{vigil_} {}

Expected<std::unique_ptr<Participant>, TransportError> Participant::join(const Network& network,
                                                                         std::uint32_t number,
                                                                         TimeMode mode,
                                                                         PeerLost lost) {
  ignore_environment();
  route_fastdds_log();
  auto lock = NameLock::take("furrow-participant-" + network.interface + "-" +
                             std::to_string(network.domain) + "-" + std::to_string(number));
  if (!lock) {
    return Unexpected{TransportError{"participant " + std::to_string(number) + " of domain " +
                                     std::to_string(network.domain) + " runs already"}};
  }
  if (auto why = refusal(network, number)) return Unexpected{std::move(*why)};

  std::unique_ptr<Participant> self{new Participant{std::move(*lock), std::move(lost)}};
  self->dds_ = dds::DomainParticipantFactory::get_instance()->create_participant(
      network.domain, participant_qos(network, number, mode), &self->listener_,
      dds::StatusMask::none());
  if (self->dds_ == nullptr) {
    return Unexpected{TransportError{"the middleware refused participant " +
                                     std::to_string(number) + " on " + network.interface}};
  }
  dds::PublisherQos publisher;
  publisher.partition().push_back(network.run.c_str());
  self->publisher_ = self->dds_->create_publisher(publisher);
  dds::SubscriberQos subscriber;
  subscriber.partition().push_back(network.run.c_str());
  self->subscriber_ = self->dds_->create_subscriber(subscriber);
  require(self->publisher_ != nullptr && self->subscriber_ != nullptr,
          "a participant has a publisher and a subscriber");
  return self;
}

Participant::~Participant() { close(); }

void Participant::close() {
  if (dds_ == nullptr) return;
  dds_->set_listener(nullptr);
  dds_->delete_contained_entities();
  vigil_.end();
  dds::DomainParticipantFactory::get_instance()->delete_participant(dds_);
  dds_ = nullptr;
}

dds::Topic* Participant::topic(const std::string& name, const dds::TypeSupport& type) {
  const std::string full = std::string{topic_prefix} + name;
  if (auto* known = dynamic_cast<dds::Topic*>(dds_->lookup_topicdescription(full))) return known;
  type.register_type(dds_);
  dds::Topic* const made = dds_->create_topic(full, type.get_type_name(), dds::TopicQos{});
  require(made != nullptr, "a topic is made once, with a registered type");
  return made;
}

dds::DataWriter* Participant::add_writer(dds::Topic* topic, Quality quality) {
  dds::DataWriterQos qos;
  apply(quality, qos);
  auto& times = qos.reliable_writer_qos().times;
  times.heartbeatPeriod = dds_time(std::chrono::milliseconds{100});
  times.nackResponseDelay = dds_time(std::chrono::milliseconds{1});
  dds::DataWriter* const writer = publisher_->create_datawriter(topic, qos);
  require(writer != nullptr, "a writer's quality of service is consistent");
  return writer;
}

dds::DataReader* Participant::add_reader(dds::Topic* topic, Quality quality,
                                         dds::DataReaderListener* listener) {
  dds::DataReaderQos qos;
  apply(quality, qos);
  qos.reliable_reader_qos().times.heartbeatResponseDelay = dds_time(std::chrono::milliseconds{1});
  dds::StatusMask mask = dds::StatusMask::data_available();
  mask << dds::StatusMask::liveliness_changed();
  dds::DataReader* const reader = subscriber_->create_datareader(topic, qos, listener, mask);
  require(reader != nullptr, "a reader's quality of service is consistent");
  return reader;
}

}  // namespace furrow::transport
