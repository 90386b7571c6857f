#pragma once

#include "core/messages.hpp"

#include <string>
#include <vector>

namespace furrow::app {

/// 64-bit FNV-1a over every field of every message in order, as 16 hexadecimal digits. Boots are
/// left out: each process draws its own, and what is left is what a seed determines.
///
/// Source: Fowler, Noll, Vo 1991.
std::string digest(const std::vector<Envelope>& log);

}  // namespace furrow::app
