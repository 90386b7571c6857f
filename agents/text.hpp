#pragma once

#include <cstdio>
#include <string>

namespace furrow::agents {

/// "12.3" for 12.345 and one decimal.
inline std::string fixed(double value, int decimals) {
  char digits[64];
  std::snprintf(digits, sizeof digits, "%.*f", decimals, value);
  return digits;
}

}  // namespace furrow::agents
