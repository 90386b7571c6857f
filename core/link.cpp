#include "core/link.hpp"

#include "core/random.hpp"

namespace furrow {

Arrivals arrivals(const Link& link, std::uint64_t seed, NodeId from, NodeId to, std::uint64_t seq,
                  Instant sent) {
  constexpr std::uint64_t purpose = 0x6c696e6b;  // "link"
  const auto address = [](NodeId id) {
    return static_cast<std::uint64_t>(id.kind) << 32 | id.number;
  };
  Random random{seed_for(seed, {purpose, address(from), address(to), seq})};
  const auto arrival = [&] {
    const double late_ns = random.uniform() * static_cast<double>(link.jitter.count());
    return sent + link.latency + Duration{static_cast<Duration::rep>(late_ns)};
  };

  if (random.uniform() < link.loss) return {.count = 0, .at = {}};
  const bool twice = random.uniform() < link.duplication;
  const Instant first = arrival();
  return {.count = twice ? 2 : 1, .at = {first, twice ? arrival() : first}};
}

}  // namespace furrow
