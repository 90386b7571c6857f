#pragma once

#include "core/geometry.hpp"
#include "core/ids.hpp"
#include "core/window.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>

namespace furrow {

/// Where aircraft swap battery packs and fill tanks. Swap and fill run side by side.
struct Station {
  StationId id;
  FieldPoint position;
  std::uint32_t bays;           ///< Aircraft served at once, >= 1.
  Seconds battery_swap;         ///< T_e.
  Seconds fill_base;            ///< t_b: coupling, mixing; spent even for a nearly full tank.
  Seconds fill_full;            ///< T_p,max: time to fill an empty tank, base included.
  std::optional<Volume> mix{};  ///< There at the start; none: no end of it.
  std::optional<std::uint32_t> packs{};  ///< Charged ones at the start; none: no end of them.
  Seconds available_from{};  ///< Mission time at which the first service begins at the earliest.
  std::optional<Seconds> available_until{};  ///< All services are done by then; none: no end.
};

/// Time to fill `share` of a tank, 0 < share <= 1; nothing to fill takes no time.
/// Source: Wang et al. 2017, equation (9).
constexpr Seconds fill_time(const Station& s, double share) {
  return share <= 0.0 ? Seconds{} : s.fill_base + share * (s.fill_full - s.fill_base);
}

/// Time in the bay.
constexpr Seconds service_time(const Station& s, bool swap, double fill_share) {
  return std::max(swap ? s.battery_swap : Seconds{}, fill_time(s, fill_share));
}

/// When plans have its last service done at the latest; none: no end.
constexpr std::optional<Seconds> planned_until(const Station& s) {
  return planned_end(s.available_from, s.available_until);
}

/// Whether it keeps a service that begins then and takes so long.
constexpr bool keeps(const Station& s, Seconds begins, Seconds service) {
  return begins >= s.available_from &&
         (!s.available_until || begins + service <= *s.available_until);
}

}  // namespace furrow
