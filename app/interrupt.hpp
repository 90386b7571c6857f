#pragma once

namespace furrow::app {

/// From now on Ctrl-C and TERM are noted instead of ending the process.
void catch_interrupts();

/// Whether one has come since.
bool is_interrupted();

}  // namespace furrow::app
