#pragma once

#include "app/results/result.hpp"

#include <string>

namespace furrow::app {

/// result.json: ordered keys, two spaces of indent, a final newline. Numbers are rounded to
/// micro-units (1e-6 of the key's unit), so that they read well and no last bit of a sum shows.
std::string result_json(const Result& result);

}  // namespace furrow::app
