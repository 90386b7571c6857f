#include "app/operator_line.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fmt/format.h>
#include <string_view>
#include <utility>

#include <sys/socket.h>
#include <sys/time.h>
#include <sys/un.h>
#include <unistd.h>

namespace furrow::app {
namespace {

constexpr std::size_t longest_line = 1000;
constexpr timeval caller_patience{.tv_sec = 0, .tv_usec = 100'000};  // it speaks as it calls

std::uint64_t hash(std::string_view text) {
  std::uint64_t state = 0xcbf29ce484222325u;
  for (const char c : text) state = (state ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return state;
}

struct Address {
  sockaddr_un at;
  socklen_t size;
};

// A name in the abstract name space, which begins with a zero byte: too short for a whole path.
Address address(const std::filesystem::path& folder) {
  std::error_code unknown;
  const auto absolute = std::filesystem::absolute(folder, unknown);  // which need not exist yet
  const auto whole = std::filesystem::weakly_canonical(absolute, unknown);
  const std::string name =
      fmt::format("furrow-operate-{:016x}", hash((unknown ? absolute : whole).string()));
  Address address{};
  address.at.sun_family = AF_UNIX;
  std::memcpy(address.at.sun_path + 1, name.data(), name.size());
  address.size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
  return address;
}

const sockaddr* generic(const Address& address) {
  return reinterpret_cast<const sockaddr*>(&address.at);
}

bool is_own_user(int socket) {
  ucred peer{};
  socklen_t size = sizeof peer;
  if (::getsockopt(socket, SOL_SOCKET, SO_PEERCRED, &peer, &size) != 0) return false;
  return peer.uid == ::geteuid() || peer.uid == 0;
}

void set_patience(int socket, timeval patience) {
  ::setsockopt(socket, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
}

// Up to the end of the line; none where it does not come.
std::optional<std::string> line_from(int socket) {
  std::string line;
  std::array<char, 256> part{};
  while (line.size() < longest_line) {
    const ssize_t got = ::recv(socket, part.data(), part.size(), 0);
    if (got <= 0) return std::nullopt;
    line.append(part.data(), static_cast<std::size_t>(got));
    if (line.back() == '\n') return line.substr(0, line.size() - 1);
  }
  return std::nullopt;
}

void say(int socket, const std::string& line) {
  const std::string text = line + '\n';
  [[maybe_unused]] const auto sent = ::send(socket, text.data(), text.size(), MSG_NOSIGNAL);
}

void hang_up(int socket) {
  if (socket >= 0) ::close(socket);
}

// "1 refused: ..."
std::optional<Answer> answer_of(const std::string& line) {
  if (line.size() < 2 || line[0] < '0' || line[0] > '3' || line[1] != ' ') return std::nullopt;
  return Answer{.code = line[0] - '0', .text = line.substr(2)};
}

}  // namespace

Caller::Caller(Caller&& other) noexcept
    : socket_{std::exchange(other.socket_, -1)}, said_{std::move(other.said_)} {}

Caller& Caller::operator=(Caller&& other) noexcept {
  std::swap(socket_, other.socket_);
  std::swap(said_, other.said_);
  return *this;
}

Caller::~Caller() { hang_up(socket_); }

void Caller::answer(const Answer& answer) const {
  say(socket_, fmt::format("{} {}", answer.code, answer.text));
}

OperatorLine::OperatorLine(OperatorLine&& other) noexcept
    : socket_{std::exchange(other.socket_, -1)} {}

OperatorLine& OperatorLine::operator=(OperatorLine&& other) noexcept {
  std::swap(socket_, other.socket_);
  return *this;
}

OperatorLine::~OperatorLine() { hang_up(socket_); }

Expected<OperatorLine, std::string> OperatorLine::open(const std::filesystem::path& folder) {
  const Address at = address(folder);
  OperatorLine line{::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)};
  constexpr int most_waiting = 16;
  const bool is_open = line.socket_ >= 0 && ::bind(line.socket_, generic(at), at.size) == 0 &&
                       ::listen(line.socket_, most_waiting) == 0;
  if (is_open) return line;
  return Unexpected{fmt::format("this run takes no orders: another one writes its results to {}",
                                folder.string())};
}

std::vector<Caller> OperatorLine::callers() {
  std::vector<Caller> all;
  for (;;) {
    const int socket = ::accept4(socket_, nullptr, nullptr, SOCK_CLOEXEC);
    if (socket < 0) return all;
    set_patience(socket, caller_patience);
    auto said = is_own_user(socket) ? line_from(socket) : std::nullopt;
    Caller caller{socket, said.value_or("")};
    if (said) all.push_back(std::move(caller));
  }
}

Expected<std::optional<Answer>, std::string> call_run(const std::filesystem::path& folder,
                                                      const std::string& line,
                                                      std::chrono::seconds patience) {
  const Address at = address(folder);
  const int socket = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const Caller own_end{socket, line};
  if (socket < 0 || ::connect(socket, generic(at), at.size) != 0) {
    return Unexpected{
        fmt::format("no run is going on that writes its results to {}", folder.string())};
  }
  set_patience(socket, {.tv_sec = patience.count(), .tv_usec = 0});
  say(socket, line);
  const auto answered = line_from(socket);
  return answered ? answer_of(*answered) : std::nullopt;
}

}  // namespace furrow::app
