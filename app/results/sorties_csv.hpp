#pragma once

#include "app/results/result.hpp"

#include <string>

namespace furrow::app {

/// sorties.csv: a header and a line per sortie, after RFC 4180. What a last sortie does not have is
/// left empty.
std::string sorties_csv(const Result& result);

}  // namespace furrow::app
