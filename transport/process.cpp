#include "transport/process.hpp"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <thread>
#include <utility>

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace furrow::transport {
namespace {

int code_of(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status); }

// Between fork and exec: only calls that are safe in a process with other threads.
[[noreturn]] void become(char* const* argv, pid_t parent) {
  // The parent's handlers are not the child's, and all signals are blocked here.
  for (int number = 1; number < NSIG; ++number) ::signal(number, SIG_DFL);
  // A terminal sends these to parent and children alike; the parent decides what they mean.
  for (const int number : {SIGINT, SIGHUP}) ::signal(number, SIG_IGN);
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(127);  // the parent ended before it could be watched
  ::execve(argv[0], argv, environ);
  ::_exit(127);
}

}  // namespace

Expected<Process, TransportError> Process::spawn(const std::vector<std::string>& argv) {
  if (argv.empty() || ::access(argv[0].c_str(), X_OK) != 0) {
    return Unexpected{
        TransportError{"cannot start `" + (argv.empty() ? "" : argv[0]) + "`: no such program"}};
  }
  std::vector<char*> arguments;
  for (const auto& a : argv) arguments.push_back(const_cast<char*>(a.c_str()));
  arguments.push_back(nullptr);
  const pid_t parent = ::getpid();
  sigset_t all, before;
  ::sigfillset(&all);
  ::pthread_sigmask(SIG_SETMASK, &all, &before);
  const pid_t pid = ::fork();
  if (pid == 0) become(arguments.data(), parent);
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  if (pid < 0) {
    return Unexpected{TransportError{"cannot start `" + argv[0] + "`: " + std::strerror(errno)}};
  }
  return Process{pid};
}

Process::Process(Process&& other) noexcept
    : pid_{std::exchange(other.pid_, 0)}, code_{other.code_} {}

Process& Process::operator=(Process&& other) noexcept {
  std::swap(pid_, other.pid_);
  std::swap(code_, other.code_);
  return *this;
}

Process::~Process() {
  if (pid_ == 0 || exit_code()) return;
  signal(SIGKILL);
  int status = 0;
  ::waitpid(pid_, &status, 0);
}

std::optional<int> Process::exit_code() {
  int status = 0;
  if (!code_ && ::waitpid(pid_, &status, WNOHANG) == pid_) code_ = code_of(status);
  return code_;
}

std::optional<int> Process::wait(std::chrono::milliseconds patience) {
  const auto end = std::chrono::steady_clock::now() + patience;
  while (!exit_code() && std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(std::chrono::milliseconds{2});
  }
  return exit_code();
}

void Process::signal(int number) {
  if (!exit_code()) ::kill(pid_, number);
}

}  // namespace furrow::transport
