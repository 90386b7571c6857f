#include "app/interrupt.hpp"

#include <csignal>

namespace furrow::app {
namespace {

volatile std::sig_atomic_t interrupted = 0;

extern "C" void note_interrupt(int) { interrupted = 1; }

}  // namespace

void catch_interrupts() {
  std::signal(SIGINT, note_interrupt);
  std::signal(SIGTERM, note_interrupt);
  std::signal(SIGHUP, note_interrupt);
}

bool is_interrupted() { return interrupted != 0; }

}  // namespace furrow::app
