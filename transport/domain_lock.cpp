#include "transport/domain_lock.hpp"

#include "transport/ports.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <utility>

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace furrow::transport {
namespace {

// Another DDS application may sit on the ports that the first participants of this domain need.
bool has_free_ports(const std::string& interface, std::uint32_t domain) {
  for (const std::uint32_t number : {director_participant, scheduler_participant}) {
    if (!is_port_free(interface, discovery_port(domain, number))) return false;
    if (!is_port_free(interface, user_port(domain, number))) return false;
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
