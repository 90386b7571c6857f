#pragma once

#include "core/expected.hpp"
#include "transport/network.hpp"

#include <string>

namespace furrow::transport {

/// A name that at most one process of this host holds at a time. The kernel frees it when the
/// process ends, however it ends.
class NameLock {
 public:
  static Expected<NameLock, TransportError> take(const std::string& name);
  NameLock(NameLock&& other) noexcept;
  NameLock& operator=(NameLock&& other) noexcept;
  ~NameLock();

 private:
  explicit NameLock(int socket) : socket_{socket} {}
  int socket_ = -1;
};

/// A DDS domain reserved for one run on this host.
class DomainLock {
 public:
  /// The lowest domain that no other run holds and whose director's ports are free.
  static Expected<DomainLock, TransportError> any_free(const std::string& interface = "127.0.0.1");

  std::uint32_t domain() const { return domain_; }

 private:
  DomainLock(std::uint32_t domain, NameLock lock) : domain_{domain}, lock_{std::move(lock)} {}
  std::uint32_t domain_;
  NameLock lock_;
};

}  // namespace furrow::transport
