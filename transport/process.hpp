#pragma once

#include "core/expected.hpp"
#include "transport/network.hpp"

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace furrow::transport {

/// A child process. It is killed when its owner lets go of it, and dies with the thread that
/// spawned it. Ctrl-C on the terminal is the parent's to hear, not its own.
class Process {
 public:
  /// @param argv  The program's path, then its arguments.
  static Expected<Process, TransportError> spawn(const std::vector<std::string>& argv);

  Process(Process&& other) noexcept;
  Process& operator=(Process&& other) noexcept;
  ~Process();

  pid_t pid() const { return pid_; }

  /// Its exit code, 128 + the signal if one ended it; nothing while it runs.
  std::optional<int> exit_code();

  /// As exit_code, after waiting for it at most `patience`.
  std::optional<int> wait(std::chrono::milliseconds patience);

  /// Sends SIGTERM, SIGKILL or any other signal, unless it has ended.
  void signal(int number);

 private:
  explicit Process(pid_t pid) : pid_{pid} {}
  pid_t pid_ = 0;
  std::optional<int> code_;
};

}  // namespace furrow::transport
