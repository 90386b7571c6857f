#pragma once

#include "core/expected.hpp"
#include "transport/member.hpp"

#include <variant>

namespace furrow::transport {

/// run_member in granted time.
Expected<std::monostate, TransportError> run_granted_member(const MemberSettings& settings,
                                                            NodeHost host);

}  // namespace furrow::transport
