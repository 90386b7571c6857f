#pragma once
// Positions and displacements that know the frame they are expressed in.

#include "core/units.hpp"

#include <cmath>
#include <span>

namespace furrow {

struct FieldFrame;  ///< East-north plane, origin at the field datum, axes true east and true north.

/// A difference of positions in one frame.
template <class Frame>
struct Vector2 {
  Length x, y;
  friend constexpr bool operator==(const Vector2&, const Vector2&) = default;
};

/// A place in one frame. Places subtract to a Vector2 and do not add.
template <class Frame>
struct Position2 {
  Length x, y;
  friend constexpr Vector2<Frame> operator-(Position2 a, Position2 b) {
    return {a.x - b.x, a.y - b.y};
  }
  friend constexpr Position2 operator+(Position2 a, Vector2<Frame> d) {
    return {a.x + d.x, a.y + d.y};
  }
  friend constexpr bool operator==(const Position2&, const Position2&) = default;
};

using FieldPoint = Position2<FieldFrame>;
using FieldVector = Vector2<FieldFrame>;

/// A place in the field frame from metres east and metres north.
constexpr FieldPoint at_m(double east_m, double north_m) {
  return {metres(east_m), metres(north_m)};
}

template <class Frame>
Length distance(Position2<Frame> a, Position2<Frame> b) {
  return metres(std::hypot((b.x - a.x).base(), (b.y - a.y).base()));
}

/// Along a way of straight legs.
inline Length way_length(std::span<const FieldPoint> way) {
  Length sum{};
  for (std::size_t i = 1; i < way.size(); ++i) sum += distance(way[i - 1], way[i]);
  return sum;
}

}  // namespace furrow
