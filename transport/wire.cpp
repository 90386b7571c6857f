#include "transport/wire.hpp"

#include "core/require.hpp"
#include "transport/wire_fields.hpp"

namespace furrow::transport {

template <std::size_t topic>
WireType<topic> encoded(const Envelope& envelope, BootId process) {
  const auto* const body = std::get_if<topic>(&envelope.body);
  require(body != nullptr, "a message is encoded for its own topic");
  WireType<topic> sample;
  auto& header = sample.header();
  header.boot_id(number(process));
  header.seq(envelope.seq);
  header.t_ns(envelope.sent.time_since_epoch().count());
  header.sender_kind(static_cast<std::uint8_t>(envelope.from.kind));
  header.sender_number(envelope.from.number);
  if constexpr (requires { sample.source(); }) {
    sample.source(static_cast<std::uint32_t>(envelope.from.kind) << 24 | envelope.from.number);
  }
  Encode encode;
  fields(encode, *body, sample);
  return sample;
}

template <std::size_t topic>
std::optional<Envelope> decoded(WireType<topic>& sample) {
  Decode decode;
  auto& header = sample.header();
  Envelope envelope{};
  decode.bounded(envelope.from.kind, header.sender_kind(), NodeKind::scheduler, NodeKind::director);
  decode(envelope.from.number, header.sender_number());
  decode(envelope.seq, header.seq());
  decode(envelope.sent, header.t_ns());
  fields(decode, envelope.body.template emplace<topic>(), sample);
  if (!decode.valid) return std::nullopt;
  return envelope;
}

#define FURROW_WIRE(topic)                                          \
  template WireType<topic> encoded<topic>(const Envelope&, BootId); \
  template std::optional<Envelope> decoded<topic>(WireType<topic>&);
FURROW_WIRE(0)
FURROW_WIRE(1)
FURROW_WIRE(2)
FURROW_WIRE(3)
FURROW_WIRE(4)
FURROW_WIRE(5)
FURROW_WIRE(6)
FURROW_WIRE(7)
FURROW_WIRE(8)
FURROW_WIRE(9)
FURROW_WIRE(10)
FURROW_WIRE(11)
FURROW_WIRE(12)
FURROW_WIRE(13)
FURROW_WIRE(14)
FURROW_WIRE(15)
FURROW_WIRE(16)
FURROW_WIRE(17)
#undef FURROW_WIRE
static_assert(std::variant_size_v<Body> == 18);

}  // namespace furrow::transport
