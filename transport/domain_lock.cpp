#include "transport/domain_lock.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <utility>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace furrow::transport {
namespace {

// Another DDS application may sit on the ports that the director of this domain would need.
bool has_free_ports(const std::string& interface, std::uint32_t domain) {
  for (const std::uint32_t offset : {10u, 11u, 12u, 13u}) {
    const int fd = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(7400 + 250 * domain + offset));
    ::inet_pton(AF_INET, interface.c_str(), &address.sin_addr);
    const bool free = ::bind(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
    ::close(fd);
    if (!free) return false;
  }
  return true;
}

}  // namespace

Expected<NameLock, TransportError> NameLock::take(const std::string& name) {
  // A name in the abstract name space (it begins with a zero byte) leaves nothing on disk.
  const int fd = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::size_t length = std::min(name.size(), sizeof address.sun_path - 1);
  std::memcpy(address.sun_path + 1, name.data(), length);
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + length);
  if (fd < 0 || ::bind(fd, reinterpret_cast<const sockaddr*>(&address), size) != 0) {
    if (fd >= 0) ::close(fd);
    return Unexpected{TransportError{name + " is held by another process"}};
  }
  return NameLock{fd};
}

NameLock::NameLock(NameLock&& other) noexcept : socket_{std::exchange(other.socket_, -1)} {}

NameLock& NameLock::operator=(NameLock&& other) noexcept {
  std::swap(socket_, other.socket_);
  return *this;
}

NameLock::~NameLock() {
  if (socket_ >= 0) ::close(socket_);
}

Expected<DomainLock, TransportError> DomainLock::any_free(const std::string& interface) {
  for (std::uint32_t domain = 0; domain <= max_domain; ++domain) {
    auto lock = NameLock::take("furrow-domain-" + std::to_string(domain));
    if (lock && has_free_ports(interface, domain)) return DomainLock{domain, std::move(*lock)};
  }
  return Unexpected{TransportError{"no DDS domain of 0 .. 100 is free on " + interface}};
}

}  // namespace furrow::transport
