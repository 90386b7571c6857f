#pragma once
// The line on which `furrow operate` speaks to a run of the same host and user.

#include "core/expected.hpp"

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace furrow::app {

/// What a caller is told.
struct Answer {
  int code;          ///< The exit code of `furrow operate`.
  std::string text;  ///< One line.
};

/// One who has called and waits for an answer. Hangs up when destroyed.
class Caller {
 public:
  Caller(int socket, std::string said) : socket_{socket}, said_{std::move(said)} {}
  Caller(Caller&& other) noexcept;
  Caller& operator=(Caller&& other) noexcept;
  ~Caller();

  const std::string& said() const { return said_; }
  void answer(const Answer& answer) const;

 private:
  int socket_;
  std::string said_;
};

/// The run's end of the line. It is named by the folder of the run's results, leaves nothing on
/// disk, and ends with the process however that ends.
class OperatorLine {
 public:
  /// @error  A sentence: another run of this host writes its results to the same folder.
  static Expected<OperatorLine, std::string> open(const std::filesystem::path& folder);
  OperatorLine(OperatorLine&& other) noexcept;
  OperatorLine& operator=(OperatorLine&& other) noexcept;
  ~OperatorLine();

  /// Those who have called since the last time. Other users than the run's own are not heard.
  std::vector<Caller> callers();

 private:
  explicit OperatorLine(int socket) : socket_{socket} {}
  int socket_;
};

/// Calls the run that will write its results to `folder`, says one line and waits for the answer.
///
/// @return  None: it did not answer within `patience`.
/// @error   A sentence: there is no such run.
Expected<std::optional<Answer>, std::string> call_run(const std::filesystem::path& folder,
                                                      const std::string& line,
                                                      std::chrono::seconds patience);

}  // namespace furrow::app
