#pragma once
// Names of the members of a fleet. Numbers are the scenario's own and never reused within a run.

#include <compare>
#include <cstdint>
#include <string>

namespace furrow {

enum class AgentId : std::uint32_t {};
enum class StationId : std::uint32_t {};

/// One start of one process's node; a restarted node has another.
enum class BootId : std::uint64_t {};

/// The incarnation of the scheduler that gave an order; a higher one fences a lower one off.
enum class Epoch : std::uint32_t {};

constexpr std::uint32_t number(AgentId id) { return static_cast<std::uint32_t>(id); }
constexpr std::uint32_t number(StationId id) { return static_cast<std::uint32_t>(id); }
constexpr std::uint64_t number(BootId id) { return static_cast<std::uint64_t>(id); }
constexpr std::uint32_t number(Epoch id) { return static_cast<std::uint32_t>(id); }

enum class NodeKind : std::uint8_t { scheduler = 1, station = 2, agent = 3, director = 4 };

/// The address of a node: its kind and its number among its kind. The scheduler is number 0, and
/// so is the director, who speaks for the operator.
struct NodeId {
  NodeKind kind;
  std::uint32_t number;
  friend constexpr auto operator<=>(NodeId, NodeId) = default;
};

constexpr NodeId scheduler_node() { return {NodeKind::scheduler, 0}; }
constexpr NodeId director_node() { return {NodeKind::director, 0}; }
constexpr NodeId node(StationId id) { return {NodeKind::station, number(id)}; }
constexpr NodeId node(AgentId id) { return {NodeKind::agent, number(id)}; }

/// "scheduler", "station 2", "agent 7": as logs and error messages say it.
std::string text(NodeId id);

}  // namespace furrow
