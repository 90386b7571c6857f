#pragma once

#include "core/expected.hpp"
#include "transport/member.hpp"

#include <variant>

namespace furrow::transport {

/// run_member on the wall clock.
Expected<std::monostate, TransportError> run_wall_member(const MemberSettings& settings,
                                                         NodeHost host);

}  // namespace furrow::transport
