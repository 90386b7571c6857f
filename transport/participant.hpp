#pragma once
// One DDS participant with everything set in code. The rest of the folder sees writers, readers and
// the participant numbers of a run.

#include "core/expected.hpp"
#include "transport/checked_type.hpp"
#include "transport/contract.hpp"
#include "transport/domain_lock.hpp"
#include "transport/network.hpp"
#include "transport/vigil.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>

namespace furrow::transport {

namespace dds = eprosima::fastdds::dds;

/// Where a sample comes from.
struct Origin {
  std::uint32_t participant;
  std::uint64_t sequence;  ///< 1, 2, 3, ... of the topic's writer.
};

/// Samples as they come, from a middleware thread: in order for each instance of a writer only.
template <class T>
class Reader final : public dds::DataReaderListener {
 public:
  using Taken = std::function<void(Origin, Received<T>&)>;

  Reader(Taken taken, Vigil& vigil) : taken_{std::move(taken)}, vigil_{vigil} {}

  std::uint32_t matched() const {
    dds::SubscriptionMatchedStatus status;
    dds_->get_subscription_matched_status(status);
    return static_cast<std::uint32_t>(status.current_count);
  }

 private:
  friend class Participant;
  void on_data_available(dds::DataReader* reader) override;
  void on_liveliness_changed(dds::DataReader*, const dds::LivelinessChangedStatus& s) override;

  Taken taken_;
  Vigil& vigil_;
  Received<T> received_;  // samples of one reader are taken by one thread
  dds::DataReader* dds_ = nullptr;
};

template <class T>
class Writer {
 public:
  Writer() = default;

  /// @return  The sample's sequence number, 0 if the middleware refused it.
  std::uint64_t write(T& sample);

  std::uint32_t matched() const {
    dds::PublicationMatchedStatus status;
    dds_->get_publication_matched_status(status);
    return static_cast<std::uint32_t>(status.current_count);
  }

  /// Keeps the lease of a leased topic.
  void assert_alive() { dds_->assert_liveliness(); }

  /// Whether every reader has acknowledged everything within `patience`.
  bool wait_for_acknowledgements(std::chrono::milliseconds patience);

 private:
  friend class Participant;
  explicit Writer(dds::DataWriter* writer) : dds_{writer} {}
  dds::DataWriter* dds_ = nullptr;
};

class Participant {
 public:
  /// Refuses a participant number that another process of this host and domain holds.
  static Expected<std::unique_ptr<Participant>, TransportError> join(const Network& network,
                                                                     std::uint32_t number,
                                                                     TimeMode mode, PeerLost lost);
  ~Participant();
  Participant(const Participant&) = delete;
  Participant& operator=(const Participant&) = delete;

  /// Leaves the run: no listener is called any more. Writers and readers are void from then on.
  void close();

  /// @param topic  Without the prefix.
  template <class T>
  Writer<T> writer(const std::string& topic, const std::string& type, Quality quality);

  /// The reader lives as long as the participant.
  template <class T>
  Reader<T>& reader(const std::string& topic, const std::string& type, Quality quality,
                    typename Reader<T>::Taken taken);

 private:
  struct Listener final : dds::DomainParticipantListener {
    explicit Listener(Vigil& v) : vigil{v} {}
    Vigil& vigil;
    void on_participant_discovery(
        dds::DomainParticipant*,
        eprosima::fastrtps::rtps::ParticipantDiscoveryInfo&& info) override;
  };

  Participant(NameLock lock, PeerLost lost);
  dds::Topic* topic(const std::string& name, const dds::TypeSupport& type);
  dds::DataWriter* add_writer(dds::Topic* topic, Quality quality);
  dds::DataReader* add_reader(dds::Topic* topic, Quality quality,
                              dds::DataReaderListener* listener);

  NameLock lock_;
  Vigil vigil_;
  Listener listener_;
  dds::DomainParticipant* dds_ = nullptr;
  dds::Publisher* publisher_ = nullptr;
  dds::Subscriber* subscriber_ = nullptr;
  std::vector<std::unique_ptr<dds::DataReaderListener>> listeners_;  // outlive their readers
};

/// The number of the participant that an entity belongs to.
std::uint32_t participant_of(const eprosima::fastrtps::rtps::GuidPrefix_t& prefix);

template <class T>
void Reader<T>::on_data_available(dds::DataReader* reader) {
  dds::SampleInfo info;
  while (reader->take_next_sample(&received_, &info) ==
         eprosima::fastrtps::types::ReturnCode_t::RETCODE_OK) {
    if (!info.valid_data) continue;  // no meaning is given to a disposed instance
    const auto& identity = info.sample_identity;
    taken_({.participant = participant_of(identity.writer_guid().guidPrefix),
            .sequence = identity.sequence_number().to64long()},
           received_);
  }
}

template <class T>
void Reader<T>::on_liveliness_changed(dds::DataReader*, const dds::LivelinessChangedStatus& s) {
  const auto guid = eprosima::fastrtps::rtps::iHandle2GUID(s.last_publication_handle);
  const std::uint32_t participant = participant_of(guid.guidPrefix);
  // A return while a lapse is still being told cancels out to no change at all.
  if (s.not_alive_count_change > 0) {
    vigil_.suspect(participant);
  } else {
    vigil_.hear(participant);
  }
}

template <class T>
std::uint64_t Writer<T>::write(T& sample) {
  eprosima::fastrtps::rtps::WriteParams params;
  if (!dds_->write(&sample, params)) return 0;
  return params.sample_identity().sequence_number().to64long();
}

template <class T>
bool Writer<T>::wait_for_acknowledgements(std::chrono::milliseconds patience) {
  const eprosima::fastrtps::Duration_t time{
      static_cast<std::int32_t>(patience.count() / 1000),
      static_cast<std::uint32_t>(patience.count() % 1000) * 1'000'000u};
  return dds_->wait_for_acknowledgments(time) ==
         eprosima::fastrtps::types::ReturnCode_t::RETCODE_OK;
}

template <class T>
Writer<T> Participant::writer(const std::string& name, const std::string& type, Quality quality) {
  return Writer<T>{add_writer(topic(name, dds::TypeSupport{new CheckedType<T>{type}}), quality)};
}

template <class T>
Reader<T>& Participant::reader(const std::string& name, const std::string& type, Quality quality,
                               typename Reader<T>::Taken taken) {
  auto owned = std::make_unique<Reader<T>>(std::move(taken), vigil_);
  Reader<T>& reader = *owned;
  listeners_.push_back(std::move(owned));
  reader.dds_ =
      add_reader(topic(name, dds::TypeSupport{new CheckedType<T>{type}}), quality, &reader);
  return reader;
}

}  // namespace furrow::transport
