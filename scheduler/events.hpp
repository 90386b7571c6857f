#pragma once
// How events of the scheduler word what they are about.

#include "core/messages.hpp"

#include <string>
#include <string_view>
#include <utility>

namespace furrow::scheduler {

inline Event event(std::string_view kind, std::string detail) {
  return {std::string{kind}, std::move(detail)};
}

inline std::string text(CellRange cells) {
  return "cells " + std::to_string(cells.first) + " to " + std::to_string(end(cells) - 1) + " (" +
         std::to_string(cells.count) + ")";
}

inline std::string text(AgentId agent) { return furrow::text(node(agent)); }

}  // namespace furrow::scheduler
