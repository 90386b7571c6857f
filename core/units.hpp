#pragma once
// Quantities that carry their unit in their type.
//
// Three bases cover spraying: metre, second, and litre of mix. A litre stays apart from a
// cubic metre on purpose: nobody means to trade tank contents for distance cubed.

#include <compare>

namespace furrow {

/// A value in metre^M second^S litre^L. Copies like the one double it holds.
///
/// Enter through a named factory, leave by dividing by one: `flow / litres_per_minute(1)`, or by
/// `base()` where a function unwraps into metres, seconds and litres once.
template <int M, int S, int L>
class Quantity {
 public:
  constexpr Quantity() = default;  // zero
  static constexpr Quantity from_base(double value) { return Quantity{value}; }
  constexpr double base() const { return value_; }

  /// A ratio of like quantities is a plain number.
  constexpr operator double() const requires(M == 0 && S == 0 && L == 0) { return value_; }

  friend constexpr Quantity operator-(Quantity a) { return Quantity{-a.value_}; }
  friend constexpr Quantity operator+(Quantity a, Quantity b) {
    return Quantity{a.value_ + b.value_};
  }
  friend constexpr Quantity operator-(Quantity a, Quantity b) {
    return Quantity{a.value_ - b.value_};
  }
  constexpr Quantity& operator+=(Quantity b) {
    value_ += b.value_;
    return *this;
  }
  constexpr Quantity& operator-=(Quantity b) {
    value_ -= b.value_;
    return *this;
  }
  friend constexpr Quantity operator*(double k, Quantity a) { return Quantity{k * a.value_}; }
  friend constexpr auto operator<=>(Quantity, Quantity) = default;

 private:
  constexpr explicit Quantity(double value) : value_{value} {}
  double value_{};
};

template <int M1, int S1, int L1, int M2, int S2, int L2>
constexpr auto operator*(Quantity<M1, S1, L1> a, Quantity<M2, S2, L2> b) {
  return Quantity<M1 + M2, S1 + S2, L1 + L2>::from_base(a.base() * b.base());
}

template <int M1, int S1, int L1, int M2, int S2, int L2>
constexpr auto operator/(Quantity<M1, S1, L1> a, Quantity<M2, S2, L2> b) {
  return Quantity<M1 - M2, S1 - S2, L1 - L2>::from_base(a.base() / b.base());
}

using Length = Quantity<1, 0, 0>;
using Area = Quantity<2, 0, 0>;
using Seconds = Quantity<0, 1, 0>;
using Speed = Quantity<1, -1, 0>;
using Acceleration = Quantity<1, -2, 0>;
using Volume = Quantity<0, 0, 1>;
using FlowRate = Quantity<0, -1, 1>;
using ApplicationRate = Quantity<-2, 0, 1>;

constexpr Length metres(double v) { return Length::from_base(v); }
constexpr Area square_metres(double v) { return Area::from_base(v); }
constexpr Area hectares(double v) { return Area::from_base(10'000.0 * v); }
constexpr Seconds seconds(double v) { return Seconds::from_base(v); }
constexpr Speed metres_per_second(double v) { return Speed::from_base(v); }
constexpr Acceleration metres_per_second2(double v) { return Acceleration::from_base(v); }
constexpr Volume litres(double v) { return Volume::from_base(v); }
constexpr FlowRate litres_per_minute(double v) { return litres(v) / seconds(60); }
constexpr ApplicationRate litres_per_hectare(double v) { return litres(v) / hectares(1); }

}  // namespace furrow
