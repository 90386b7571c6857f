#pragma once

#include "scheduler/share_times.hpp"

#include <span>

namespace furrow::scheduler {

/// A time before which no fleet plan of the route on these aircraft is done: contiguous shares of
/// whole strips in any order of aircraft, any stations, any return points, any queue; flown at
/// constant speeds over every cell's centre. The larger of two bounds:
///
/// By share, without queues and battery swaps, which only cost time. Let F(a, b) be the optimum of
/// strips a .. b for one aircraft, served at the nearest station everywhere: no later than any plan
/// of its own. F does not fall as b rises: a plan of more strips, ended earlier, is a plan of
/// fewer. F does not rise as a does: a plan of more strips, begun later, flies to its first cell
/// straight from the home or station where its sortie began, at the ferry speed, which is no slower
/// than by the strips left out. So the last strip e(a) that an aircraft starting at strip a has
/// done by time T does not fall as a rises, and the furthest that a set S of aircraft get by T
/// together is, over their possible orders,
///
///   R(S) = max over v in S of e_v(R(S without v)),  R({}) = 0.
///
/// If R(all) leaves strips over, no plan is done by T. Aircraft alike in all but their homes are
/// counted, not told apart, each with the nearest of their homes. Of fleets with very many kinds
/// the most similar are merged, to the best of every figure, until at most 4096 sets are left.
///
/// By bays. What the route is longer than all first tanks together has been filled in, in fills of
/// one tank at most, each in a bay; bays work side by side.
///
/// Flights that accelerate, brake and turn take longer, save where arcs of half a swath are flown
/// at nearly spray speed: a right-angled corner of arc radius r is cut for a gain only above
/// pi / 4 of the spray speed.
///
/// Within 0.05 s below the larger.
double makespan_bound_s(const planner::Route& route, const RouteLengths& lengths,
                        std::span<const Vehicle> vehicles, std::span<const Station> stations);

}  // namespace furrow::scheduler
