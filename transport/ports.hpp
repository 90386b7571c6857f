#pragma once

#include <cstdint>
#include <string>

namespace furrow::transport {

/// UDP ports as RTPS lays them out: 7400 + 250 per domain, two for each participant.
constexpr std::uint32_t discovery_port(std::uint32_t domain, std::uint32_t participant) {
  return 7400 + 250 * domain + 10 + 2 * participant;
}
constexpr std::uint32_t user_port(std::uint32_t domain, std::uint32_t participant) {
  return discovery_port(domain, participant) + 1;
}

/// Whether a UDP socket can be bound there now; false, too, where `interface` is no IPv4 address of
/// this host.
bool is_port_free(const std::string& interface, std::uint32_t port);

}  // namespace furrow::transport
