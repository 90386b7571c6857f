#pragma once
// How far each search ends from the best route known, by the time it has.

#include <cstdint>
#include <string>

namespace furrow::studies {

/// Runs every planner on 20 scenes with 0.1, 1 and 10 s, then ten times more with 0.1 s and
/// `rounds` times more with 10 s; prints what lies between each and the least feasible cost that
/// any run of the scene in the table had.
///
/// A second is a number of judged curves, so that a run repeats on any machine.
/// @param runs     Table of the runs. Those that it has are not run again, new ones are appended:
///                 a study that was stopped goes on.
/// @param picture  Where the picture is drawn, SVG.
void route_gaps(const std::string& runs, const std::string& picture, std::uint64_t rounds);

}  // namespace furrow::studies
