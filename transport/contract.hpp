#pragma once
// The contract `fleet/v1`: who writes and reads each topic, and with which quality of service.

#include "core/messages.hpp"

#include <array>
#include <chrono>
#include <cstddef>
#include <optional>
#include <string_view>

namespace furrow::transport {

inline constexpr std::string_view topic_prefix = "fleet/v1/";
inline constexpr std::size_t topic_count = topics.size();

/// Which kinds of nodes, as a set of bits.
using Kinds = unsigned;
constexpr Kinds kinds(NodeKind kind) { return 1u << static_cast<unsigned>(kind); }

namespace role {
inline constexpr Kinds none = 0;
inline constexpr Kinds scheduler = kinds(NodeKind::scheduler);
inline constexpr Kinds stations = kinds(NodeKind::station);
inline constexpr Kinds agents = kinds(NodeKind::agent);
inline constexpr Kinds all = scheduler | stations | agents;
inline constexpr Kinds director = kinds(NodeKind::director);
}  // namespace role

/// Samples that a writer keeps of each instance for those who have not read them yet.
struct History {
  int depth;
  bool keep_all = false;  ///< The writer waits rather than drop what is not acknowledged.
};

struct TopicContract {
  std::string_view name;
  Kinds writers;
  Kinds readers;    ///< Besides the director, who reads all that it does not write.
  History wall;     ///< Wall clock: the newest counts, except where each message does.
  History granted;  ///< Granted time: each message counts, and a round never fills this depth.
  bool leased =
      false;  ///< Wall clock: a writer that does not assert itself for `wall_lease` is dead.
};

/// By the index of the message in Body. Every topic is RELIABLE and TRANSIENT_LOCAL, so that what
/// is sent before both ends know each other arrives, and a late joiner sees where things stand.
// clang-format off
inline constexpr std::array<TopicContract, topic_count> contract{{
    // topic             writers          readers                        wall         granted
    {"agent_info",       role::agents,    role::scheduler,               {1},         {64}},
    {"agent_state",      role::agents,    role::scheduler,               {1},         {64}, true},
    {"command",          role::scheduler, role::agents,                  {1},         {64}},
    {"command_ack",      role::agents,    role::scheduler,               {8},         {64}},
    {"work_grant",       role::scheduler, role::agents,                  {256, true}, {64}},
    {"work_report",      role::agents,    role::scheduler,               {256, true}, {64}},
    {"service_claim",    role::agents,    role::stations,                {1},         {64}},
    {"service_grant",    role::stations,  role::agents,                  {1},         {64}},
    {"station_state",    role::stations,  role::scheduler,               {1},         {64}},
    {"scheduler_state",  role::scheduler, role::agents | role::stations, {1},         {64}},
    {"event",            role::all,       role::none,                    {256, true}, {1024}},
    {"sortie_report",    role::agents,    role::none,                    {256, true}, {64}},
    {"flight_record",    role::agents,    role::none,                    {256, true}, {64}},
    {"obstacle_seen",    role::agents,    role::scheduler,               {256, true}, {64}},
    {"operator_state",   role::scheduler, role::agents,                  {1},         {64}},
    {"operator_order",   role::director,  role::scheduler,               {256, true}, {64}},
    {"flight_claim",     role::agents,    role::scheduler,               {1},         {64}},
    {"flight_grant",     role::scheduler, role::agents,                  {1},         {64}},
}};
// clang-format on

static_assert([] {
  for (std::size_t i = 0; i < topic_count; ++i) {
    if (contract[i].name != topics[i]) return false;
  }
  return true;
}());

enum class TimeMode { granted, wall };

/// What one writer or reader asks of the middleware.
struct Quality {
  History history;
  std::optional<std::chrono::milliseconds> lease{};
};

/// Longest silence of one who lives.
inline constexpr std::chrono::milliseconds wall_lease{1000};
/// The middleware's own lease; the rest of the whole is for its word to prove true. See Vigil.
inline constexpr std::chrono::milliseconds suspicion_lease{600};

constexpr Quality quality(std::size_t topic, TimeMode mode) {
  const TopicContract& c = contract[topic];
  if (mode == TimeMode::granted) return {.history = c.granted};
  return {.history = c.wall, .lease = c.leased ? std::optional{suspicion_lease} : std::nullopt};
}

/// Of time_request and time_grant: the newest supersedes.
inline constexpr Quality clock_quality{.history = {1}};

}  // namespace furrow::transport
