#pragma once

#include "core/messages.hpp"

#include <string>
#include <vector>

namespace furrow::app {

/// events.jsonl: a JSON object per line for each message but heartbeats and flight records.
/// Commands are given without their geometry.
std::string events_jsonl(const std::vector<Envelope>& log);

}  // namespace furrow::app
