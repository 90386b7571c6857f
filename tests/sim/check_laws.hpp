#pragma once

#include "sim/checkers/laws.hpp"
#include "sim/simulate.hpp"

#include <catch2/catch.hpp>

namespace furrow::sim {

/// Fails the test with each law that a mission breaks.
inline void check_laws(const Facts& facts, const Log& log) {
  for (const Violation& v : violations(facts, log.envelopes, log.ended)) {
    FAIL_CHECK(v.law << ": " << v.detail);
  }
}

}  // namespace furrow::sim
