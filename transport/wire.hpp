#pragma once
// The door between the wire's types and the core's values.

#include "core/messages.hpp"

#include <cstddef>
#include <optional>
#include <tuple>
#include <variant>

#include "idl/agent.h"
#include "idl/command.h"
#include "idl/flight.h"
#include "idl/obstacle.h"
#include "idl/operator.h"
#include "idl/record.h"
#include "idl/scheduler.h"
#include "idl/supply.h"
#include "idl/work.h"

namespace furrow::transport {

/// The wire's types by the index of the message in Body.
using WireTypes =
    std::tuple<fleet::v1::AgentInfo, fleet::v1::AgentState, fleet::v1::Command,
               fleet::v1::CommandAck, fleet::v1::WorkGrant, fleet::v1::WorkReport,
               fleet::v1::ServiceClaim, fleet::v1::ServiceGrant, fleet::v1::StationState,
               fleet::v1::SchedulerState, fleet::v1::Event, fleet::v1::SortieReport,
               fleet::v1::FlightRecord, fleet::v1::ObstacleSeen, fleet::v1::OperatorState,
               fleet::v1::OperatorOrder, fleet::v1::FlightClaim, fleet::v1::FlightGrant>;
static_assert(std::tuple_size_v<WireTypes> == std::variant_size_v<Body>);

template <std::size_t topic>
using WireType = std::tuple_element_t<topic, WireTypes>;

/// @param process  Fills the header's boot id where the body names none.
/// @pre envelope.body.index() == topic
template <std::size_t topic>
WireType<topic> encoded(const Envelope& envelope, BootId process);

/// The envelope, unless the sample breaks a rule of the contract: an enumerated value out of range,
/// a number that is none, a sequence longer than a mission could need.
template <std::size_t topic>
std::optional<Envelope> decoded(WireType<topic>& sample);

}  // namespace furrow::transport
