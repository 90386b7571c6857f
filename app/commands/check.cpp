#include "app/conduct.hpp"

#include <cstdio>

namespace furrow::app {

int check(const Options& options) {
  const auto scenario = load(options);
  if (!scenario) return scenario.error();
  std::printf("%s: sound: %zu UAVs, %zu stations\n", options.scenario.c_str(),
              scenario->uavs.size(), scenario->stations.size());
  return Exit::done;
}

}  // namespace furrow::app
