#include "app/conduct.hpp"

#include <cstdio>

namespace furrow::app {

int check(const Options& options) {
  const auto scenario = load(options);
  if (!scenario) return scenario.error();
  const auto counted = [](std::size_t n, const char* noun) {
    return std::to_string(n) + " " + noun + (n == 1 ? "" : "s");
  };
  std::printf("%s: sound: %s, %s\n", options.scenario.c_str(),
              counted(scenario->uavs.size(), "UAV").c_str(),
              counted(scenario->stations.size(), "station").c_str());
  return Exit::done;
}

}  // namespace furrow::app
