#pragma once

#include "transport/wire.hpp"

#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>

#include <string>
#include <utility>
#include <vector>

namespace furrow {

/// An envelope as it travels: equal bytes, equal values.
inline std::string bytes(const Envelope& envelope) {
  std::string result;
  [&]<std::size_t... topic>(std::index_sequence<topic...>) {
    const auto one = [&]<std::size_t i>(std::integral_constant<std::size_t, i>) {
      if (envelope.body.index() != i) return;
      const auto sample = transport::encoded<i>(envelope, BootId{9});
      // Zeroed first, for alignment leaves gaps.
      result.assign(std::decay_t<decltype(sample)>::getCdrSerializedSize(sample), '\0');
      eprosima::fastcdr::FastBuffer buffer{result.data(), result.size()};
      eprosima::fastcdr::Cdr cdr{buffer};
      sample.serialize(cdr);
    };
    (one(std::integral_constant<std::size_t, topic>{}), ...);
  }
  (std::make_index_sequence<std::variant_size_v<Body>>{});
  return std::to_string(envelope.body.index()) + ":" + result;
}

inline std::vector<std::string> bytes(const std::vector<Envelope>& log) {
  std::vector<std::string> all;
  for (const Envelope& e : log) all.push_back(bytes(e));
  return all;
}

}  // namespace furrow
