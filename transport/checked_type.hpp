#pragma once

#include <array>
#include <cstdint>
#include <exception>
#include <functional>
#include <string>

#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>
#include <fastdds/dds/topic/TopicDataType.hpp>
#include <fastdds/rtps/common/InstanceHandle.h>
#include <fastdds/rtps/common/SerializedPayload.h>

namespace furrow::transport {

/// What a reader takes: the sample, and whether its bytes were one.
template <class T>
struct Received {
  T sample;
  bool malformed = false;
};

/// A generated type as Fast DDS wants it, in place of the generated PubSubType.
///
/// No exception of the CDR library leaves it: a sample that cannot be read is handed on as
/// `malformed` instead of ending the process, and keeps its place in its writer's sequence. Keys
/// are made in a buffer of their own, so any thread may ask for one.
///
/// Writers take a `T*`, readers give a `Received<T>*`; both start with a T.
template <class T>
class CheckedType final : public eprosima::fastdds::dds::TopicDataType {
  using Payload = eprosima::fastrtps::rtps::SerializedPayload_t;
  using Cdr = eprosima::fastcdr::Cdr;
  using FastBuffer = eprosima::fastcdr::FastBuffer;

 public:
  explicit CheckedType(const std::string& name) {
    setName(name.c_str());
    m_typeSize = static_cast<std::uint32_t>(T::getMaxCdrSerializedSize()) + encapsulation + 4;
    m_isGetKeyDefined = true;
    auto_fill_type_object(false);
    auto_fill_type_information(false);
  }

  bool serialize(void* data, Payload* payload) override {
    try {
      FastBuffer buffer{reinterpret_cast<char*>(payload->data), payload->max_size};
      Cdr cdr{buffer, Cdr::DEFAULT_ENDIAN, Cdr::DDS_CDR};
      payload->encapsulation = cdr.endianness() == Cdr::BIG_ENDIANNESS ? CDR_BE : CDR_LE;
      cdr.serialize_encapsulation();
      static_cast<const T*>(data)->serialize(cdr);
      payload->length = static_cast<std::uint32_t>(cdr.getSerializedDataLength());
      return true;
    } catch (const std::exception&) {
      return false;
    }
  }

  bool deserialize(Payload* payload, void* data) override {
    auto* const received = static_cast<Received<T>*>(data);
    received->malformed = false;
    try {
      FastBuffer buffer{reinterpret_cast<char*>(payload->data), payload->length};
      Cdr cdr{buffer, Cdr::DEFAULT_ENDIAN, Cdr::DDS_CDR};
      cdr.read_encapsulation();
      payload->encapsulation = cdr.endianness() == Cdr::BIG_ENDIANNESS ? CDR_BE : CDR_LE;
      received->sample.deserialize(cdr);
    } catch (const std::exception&) {
      received->sample = T{};
      received->malformed = true;
    }
    return true;
  }

  std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override {
    return [data] {
      return static_cast<std::uint32_t>(T::getCdrSerializedSize(*static_cast<T*>(data))) +
             encapsulation;
    };
  }

  void* createData() override { return new Received<T>; }
  void deleteData(void* data) override { delete static_cast<Received<T>*>(data); }

  /// Keys are one uint32, so the serialised key is the handle and no digest is needed.
  bool getKey(void* data, eprosima::fastrtps::rtps::InstanceHandle_t* handle, bool) override {
    static_assert(sizeof(std::uint32_t) <= 16);
    std::array<char, 16> bytes{};
    try {
      FastBuffer buffer{bytes.data(), bytes.size()};
      Cdr cdr{buffer, Cdr::BIG_ENDIANNESS};
      static_cast<const T*>(data)->serializeKey(cdr);
    } catch (const std::exception&) {
      return false;
    }
    for (unsigned i = 0; i < bytes.size(); ++i) {
      handle->value[i] = static_cast<eprosima::fastrtps::rtps::octet>(bytes[i]);
    }
    return true;
  }

 private:
  static constexpr std::uint32_t encapsulation = 4;
};

}  // namespace furrow::transport
