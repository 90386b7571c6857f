#include "core/require.hpp"

#include <cstdio>
#include <cstdlib>

namespace furrow {

void require(bool holds, std::string_view rule, const char* file, int line) {
  if (holds) return;
  std::fprintf(stderr, "furrow: internal error: broken rule: %.*s (%s:%d)\n",
               static_cast<int>(rule.size()), rule.data(), file, line);
#ifdef NDEBUG
  std::_Exit(internal_error);  // nothing after a broken rule can be trusted, destructors included
#else
  std::abort();
#endif
}

}  // namespace furrow
