#pragma once

#include "app/operator_line.hpp"
#include "core/messages.hpp"

#include <chrono>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace furrow::app {

/// Reads an order: "pause", "resume", "return_all", "stop", or "take_out" with the UAV's number.
/// @param uavs  Of the mission: numbers 1 to `uavs`.
/// @error  A sentence with the rule and the value.
Expected<OperatorOrder, std::string> operator_order(const std::string& line, std::uint32_t uavs);

/// Where orders of `furrow operate` come in while a run goes on. One order is said to the scheduler
/// at a time, again and again until it is answered, and whoever gave it is told the answer.
class OperatorDesk {
 public:
  OperatorDesk(OperatorLine line, std::uint32_t uavs) : line_{std::move(line)}, uavs_{uavs} {}
  OperatorDesk(const OperatorDesk&) = delete;
  OperatorDesk& operator=(const OperatorDesk&) = delete;
  ~OperatorDesk();

  /// What is to be said now; may be asked at any rate.
  std::vector<Body> says();

  /// Sees everything said in the run.
  void observe(const Envelope& envelope);

 private:
  using Clock = std::chrono::steady_clock;
  struct Waiting {
    Caller caller;
    OperatorOrder order;
  };
  void take_calls();

  OperatorLine line_;
  std::uint32_t uavs_;
  std::uint64_t orders_ = 0;
  std::deque<Waiting> waiting_{};
  Clock::time_point listened_{}, said_{};
};

}  // namespace furrow::app
