#pragma once
// A fixed way over a field, as straight strips that are sprayed one after the other.

#include "core/geometry.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace furrow::planner::fleet {

/// A straight strip, sprayed from `begin` to `end`. Longer than zero.
struct StraightStrip {
  FieldPoint begin, end;
  std::optional<double> hop_m{};  ///< Flown here from the strip before, >= 0; none: straight.
};

/// Strips joined by hops that are flown, not sprayed. Positions on the path count sprayed
/// metres from the first strip's begin.
class StripPath {
 public:
  /// @param strips  At least one.
  /// @param cut_m   Ways from and to places count for so much less, for bounds of aircraft that cut
  ///                the corners at their ends; >= 0.
  explicit StripPath(const std::vector<StraightStrip>& strips, double cut_m = 0.0);

  double length_m() const { return begins_m_.back(); }
  std::uint32_t strips() const { return static_cast<std::uint32_t>(strips_.size()); }
  /// Position where strip i begins; that of i == strips() is the path's length.
  double begin_m(std::uint32_t strip) const { return begins_m_[strip]; }

  /// The strip that spraying from position `at_m` begins on: at a joint, the later one.
  std::uint32_t strip_from(double at_m) const;
  /// The strip that spraying up to position `at_m` ends on: at a joint, the earlier one.
  std::uint32_t strip_to(double at_m) const;

  /// Distances from a place to where spraying from, or up to, a position begins or ends, metres.
  double out_m(FieldPoint place, double at_m) const {
    return away_m(place, strip_from(at_m), at_m);
  }
  double back_m(FieldPoint place, double at_m) const { return away_m(place, strip_to(at_m), at_m); }

  /// Hops between spraying from one position up to another, metres.
  double hops_m(double from_m, double to_m) const {
    return hops_m_[strip_to(to_m)] - hops_m_[strip_from(from_m)];
  }

  /// Number of those hops.
  std::uint32_t hops(double from_m, double to_m) const {
    return strip_to(to_m) - strip_from(from_m);
  }

  /// What lies between two positions, `from_m` < `to_m`, as a path of its own.
  StripPath part(double from_m, double to_m) const;

 private:
  struct Line {
    double x_m, y_m, along_x, along_y;
  };
  double away_m(FieldPoint place, std::uint32_t strip, double at_m) const;
  FieldPoint point(std::uint32_t strip, double at_m) const;
  std::size_t stretch_of(double at_m) const;

  double cut_m_;
  std::vector<Line> strips_;
  std::vector<double> begins_m_;  ///< By strip, and the length.
  std::vector<double> hops_m_;    ///< By strip: all hops before it.
  /// By as many equal stretches of the path: the strip that no position in it lies before.
  std::vector<std::uint32_t> first_{};
};

}  // namespace furrow::planner::fleet
