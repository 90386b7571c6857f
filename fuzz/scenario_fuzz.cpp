#include "mission/load.hpp"

#include "core/require.hpp"

#include <cstddef>
#include <cstdint>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace furrow;
  const auto scenario =
      mission::parse(std::string_view{reinterpret_cast<const char*>(data), size}, "fuzz");
  if (scenario) return 0;
  require(!scenario.error().empty(), "a refusal has a reason");
  for (const mission::ScenarioError& error : scenario.error()) {
    require(text(error).find('\n') == std::string::npos, "an error is one line");
  }
  return 0;
}
