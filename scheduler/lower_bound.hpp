#pragma once

#include "scheduler/share_times.hpp"

#include <span>

namespace furrow::scheduler {

/// A time before which no fleet plan of the route on these aircraft is done: contiguous shares of
/// whole strips in any order of aircraft, any stations, any return points, any queue. The larger of
/// two bounds, both without queues and battery swaps, which only cost time:
///
/// By share. Let every aircraft have the fastest pace. The optimum F(a, b) of strips a .. b at that
/// pace is no later than any aircraft's own plan of them. F does not fall as b rises: a plan of
/// more strips, ended earlier, is a plan of fewer. F does not rise as a does: a plan of more
/// strips, begun later, flies to its first cell straight from the home or station where its sortie
/// began, at the ferry speed, which is no slower than by the strips left out. So if taking strips
/// greedily by time T, once per aircraft, leaves some over, then no cut is done by T.
///
/// By work. By time T an aircraft has sprayed at most the distance d for which its nearest first
/// flight, d at its spray speed, ceil(d / tank) - 1 returns from the cell nearest to any station,
/// and the filling of d - tank metres take T. Distances needed: the route's, less one move between
/// cells for each cut. If all aircraft together do not reach that by T, no plan is done by T. This
/// bound keeps slow aircraft slow, but does not know how far the strips are from the stations.
///
/// Within 0.05 s below the larger.
double makespan_bound_s(const planner::Route& route, const RouteLengths& lengths,
                        std::span<const Vehicle> vehicles, std::span<const Station> stations);

}  // namespace furrow::scheduler
