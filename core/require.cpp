#include "core/require.hpp"

#include <cstdio>
#include <cstdlib>

namespace furrow {

void require(bool holds, std::string_view rule, std::source_location where) {
  if (holds) return;
  std::fprintf(stderr, "furrow: broken rule: %.*s (%s:%u in %s)\n", static_cast<int>(rule.size()),
               rule.data(), where.file_name(), static_cast<unsigned>(where.line()),
               where.function_name());
  std::abort();
}

}  // namespace furrow
