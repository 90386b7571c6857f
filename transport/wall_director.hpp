#pragma once

#include "transport/recorder.hpp"

namespace furrow::transport {

/// run_director on the wall clock: it records and grants nothing.
Expected<DirectorResult, TransportError> run_wall_director(const DirectorSettings& settings,
                                                           Participant& participant,
                                                           Incoming& incoming);

}  // namespace furrow::transport
