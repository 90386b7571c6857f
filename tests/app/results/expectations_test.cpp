#include "app/results/expectations.hpp"

#include "mission/load.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

namespace furrow::app {
namespace {

TEST_CASE("expectations: every key that a scenario may expect names a figure of the result",
          "[app]") {
  Result result{};
  result.fleet.gap = 0.0;
  result.clearance =
      ClearanceFigures{.uav = 1, .obstacle = "tree", .least_m = 1, .share = 1, .at_s = 0};
  int keys = 0;
  for (const mission::KnownKey& known : mission::known_keys()) {
    constexpr std::string_view prefix = "expect.", suffix = ".max";
    if (known.path.rfind(prefix, 0) != 0 || !known.path.ends_with(suffix)) continue;
    const std::string key =
        known.path.substr(prefix.size(), known.path.size() - prefix.size() - suffix.size());
    const auto verdicts = judged({{key, std::nullopt, 1e12}}, result);
    INFO(key);
    CHECK(verdicts.at(0).value.has_value());
    ++keys;
  }
  CHECK(keys == 15);  // besides "completed"
}

}  // namespace
}  // namespace furrow::app
