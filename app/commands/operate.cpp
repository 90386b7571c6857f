#include "app/operator_line.hpp"
#include "app/options.hpp"

#include <algorithm>
#include <cstdio>
#include <fmt/format.h>

namespace furrow::app {
namespace {

// The command line has hyphens where scenarios and logs have underscores.
std::string line_of(const Options& options) {
  std::string line = options.order;
  std::replace(line.begin(), line.end(), '-', '_');
  return options.uav.empty() ? line : line + ' ' + options.uav;
}

int refused(int code, const std::string& sentence) {
  fmt::print(stderr, "furrow: {}\n", sentence);
  return code;
}

}  // namespace

int operate(const Options& options) {
  const auto answer =
      call_run(options.folder, line_of(options), std::chrono::seconds{options.patience_s});
  if (!answer) return refused(Exit::bad_input, answer.error());
  if (!*answer) {
    return refused(Exit::not_met, fmt::format("no answer within {} s", options.patience_s));
  }
  if ((*answer)->code != Exit::done) return refused((*answer)->code, (*answer)->text);
  fmt::print("{}\n", (*answer)->text);
  return Exit::done;
}

}  // namespace furrow::app
