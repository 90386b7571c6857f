#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace furrow::app {

/// Told apart by colour-blind readers, on white and in grey print.
/// Source: Okabe, Ito 2008; its yellow darkened and its black left out.
inline constexpr std::array<std::string_view, 7> hues{"#0072b2", "#e69f00", "#009e73", "#cc79a7",
                                                      "#56b4e9", "#d55e00", "#8c7a00"};

inline constexpr std::string_view ink = "#22302a";
inline constexpr std::string_view faint_ink = "#6b7a72";
inline constexpr std::string_view rule_line = "#d9e0dc";
inline constexpr std::string_view alarm = "#b3261e";
inline constexpr std::string_view waiting = "#efe3a8";
inline constexpr std::string_view serving = "#5b6770";

/// How far off the line, from nothing to half a swath and more.
struct OffsetClass {
  double below;  ///< Share of a swath.
  std::string_view colour;
  std::string_view words;
};
inline constexpr std::array<OffsetClass, 5> offset_classes{
    {{0.02, "#d6e6f4", "under 2 %"},
     {0.05, "#9ecae1", "2 to 5 %"},
     {0.15, "#4292c6", "5 to 15 %"},
     {0.50, "#fe9929", "15 to 50 %"},
     {1e300, "#993404", "over 50 % of the swath"}}};

}  // namespace furrow::app
