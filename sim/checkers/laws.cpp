#include "sim/checkers/laws.hpp"

#include <algorithm>
#include <array>

namespace furrow::sim {

std::vector<Violation> violations(const Facts& facts, const std::vector<Envelope>& log,
                                  Instant ended) {
  const std::array checkers{work_laws(facts),   energy_laws(facts),     station_laws(facts),
                            log_laws(facts),    sender_laws(facts),     clearance_laws(facts),
                            height_laws(facts), separation_laws(facts), window_laws(facts)};
  std::vector<Violation> all;
  for (const auto& checker : checkers) {
    for (const Envelope& envelope : log) checker->observe(envelope);
    checker->conclude(ended);
    all.insert(all.end(), checker->violations().begin(), checker->violations().end());
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Violation& a, const Violation& b) { return a.at < b.at; });
  return all;
}

}  // namespace furrow::sim
