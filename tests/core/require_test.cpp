#include "core/require.hpp"

#include <catch2/catch.hpp>

#include <csignal>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace furrow {
namespace {

int status_after_a_broken_rule() {
  const pid_t child = ::fork();
  if (child == 0) {
    ::dup2(::open("/dev/null", O_WRONLY), STDERR_FILENO);
    std::signal(SIGABRT, SIG_DFL);  // not the test program's
    require(false, "a rule");
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return status;
}

TEST_CASE("require: a rule that holds does nothing", "[core]") { require(true, "a rule"); }

TEST_CASE("require: a broken rule ends the process as an internal error", "[core]") {
  const int status = status_after_a_broken_rule();
#ifdef NDEBUG
  REQUIRE(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == internal_error);
#else
  REQUIRE(WIFSIGNALED(status));
  CHECK(WTERMSIG(status) == SIGABRT);
#endif
}

}  // namespace
}  // namespace furrow
