#pragma once

#include "scheduler/joint_plan.hpp"

#include <cstdint>
#include <span>

namespace furrow::scheduler {

/// A plan whose aircraft are done as nearly together as moving cells between sorties that meet
/// makes them: from a sortie of whoever is done last to the one beside it, again and again, the
/// move that is worth most. Every move is flown as `flown_lists` flies, so it knows what the search
/// model leaves out: whole cells, corners, braking.
///
/// @param lists  That `flown_lists` carries; they have every cell once.
/// @param most   Moves tried.
/// @return  Never worth less, and in time if `lists` are.
SortieLists evened_out(const planner::Route& route, const RouteLengths& lengths,
                       std::span<const Vehicle> vehicles, std::span<const Station> stations,
                       SortieLists lists, std::span<const double> ready_s, std::uint64_t most);

}  // namespace furrow::scheduler
