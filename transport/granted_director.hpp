#pragma once

#include "transport/recorder.hpp"

namespace furrow::transport {

/// run_director in granted time.
Expected<DirectorResult, TransportError> run_granted_director(const DirectorSettings& settings,
                                                              Participant& participant,
                                                              Incoming& incoming);

}  // namespace furrow::transport
