#include "app/conduct.hpp"

namespace furrow::app {

int plan(const Options& options) { return conduct(options, Mode::plan); }

}  // namespace furrow::app
