#pragma once

namespace furrow::app {

/// From now on Ctrl-C, TERM and a closed terminal are noted instead of ending the process.
void catch_interrupts();

/// Whether one has come since.
bool is_interrupted();

/// While it lives, the second interrupt ends the process at once, with code 130: for long work that
/// does not look whether it is interrupted, and has written nothing.
class SecondInterruptEnds {
 public:
  SecondInterruptEnds();
  ~SecondInterruptEnds();
  SecondInterruptEnds(const SecondInterruptEnds&) = delete;
  SecondInterruptEnds& operator=(const SecondInterruptEnds&) = delete;
};

}  // namespace furrow::app
