#pragma once
// In which order places are visited.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace furrow::planner {

/// A short closed tour over places 0 .. places - 1 that starts at place 0: the nearest place next,
/// improved by reversing stretches and moving up to three places until nothing helps. It depends on
/// nothing but the lengths.
///
/// @param places  >= 1
/// @param length  Of the way between two places, the same both ways, >= 0.
/// @return  Every place once, 0 first. Time O(places^2) for each improvement.
///
/// Source: Croes 1958, Operations Research 6(6), 791-812 (reversing); Or 1976 (moving).
std::vector<std::uint32_t> tour(std::uint32_t places,
                                const std::function<double(std::uint32_t, std::uint32_t)>& length);

}  // namespace furrow::planner
