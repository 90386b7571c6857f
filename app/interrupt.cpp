#include "app/interrupt.hpp"

#include <csignal>
#include <string_view>

#include <unistd.h>

namespace furrow::app {
namespace {

volatile std::sig_atomic_t interrupted = 0;
volatile std::sig_atomic_t second_ends = 0;

constexpr int ended_by_interrupt = 130;  // as a shell reports it
constexpr std::string_view notice = "furrow: ends after this step; once more: at once\n";

// Only calls that are safe in a signal handler.
extern "C" void note_interrupt(int) {
  if (second_ends != 0) {
    if (interrupted != 0) ::_exit(ended_by_interrupt);
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, notice.data(), notice.size());
  }
  interrupted = 1;
}

}  // namespace

void catch_interrupts() {
  std::signal(SIGINT, note_interrupt);
  std::signal(SIGTERM, note_interrupt);
  std::signal(SIGHUP, note_interrupt);
}

bool is_interrupted() { return interrupted != 0; }

SecondInterruptEnds::SecondInterruptEnds() { second_ends = 1; }
SecondInterruptEnds::~SecondInterruptEnds() { second_ends = 0; }

}  // namespace furrow::app
