#pragma once
// What a mission shows on a terminal.

#include "app/results/result.hpp"

#include <optional>
#include <string>

namespace furrow::app {

/// The figures of a mission in lines of at most 100 columns: a row per UAV, the totals, and every
/// missed expectation and broken law.
std::string summary_table(const Result& result);

/// A line that is drawn over and over while a mission flies, at most ten times a second.
class ProgressBar {
 public:
  /// @param cells   Of the route, > 0.
  /// @param on_tty  Whether anyone sees it; otherwise it stays silent.
  ProgressBar(std::uint32_t cells, bool on_tty) : cells_{cells}, on_tty_{on_tty} {}

  /// What to write now: a carriage return and the line, or nothing when it is too early.
  ///
  /// @param wall_s     Wall-clock time since the start [s], not falling.
  /// @param mission_s  Mission time [s].
  std::string draw(std::uint32_t sprayed_cells, double mission_s, double wall_s);

  /// What takes the line off the terminal again.
  std::string clear() const;

 private:
  std::uint32_t cells_;
  bool on_tty_;
  std::optional<double> drawn_s_;
};

}  // namespace furrow::app
