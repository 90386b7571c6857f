#pragma once
// Random numbers that are a function of what they are for, so that no run depends on the order in
// which nodes happen to draw.

#include <cstdint>
#include <initializer_list>

namespace furrow {

/// Well-mixed bits of `x`. Source: Steele, Lea, Flood 2014 (SplitMix64 finaliser).
constexpr std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

/// A seed for one purpose from the scenario's seed and the names of the purpose.
constexpr std::uint64_t seed_for(std::uint64_t seed, std::initializer_list<std::uint64_t> purpose) {
  for (const std::uint64_t part : purpose) seed = mixed(seed ^ mixed(part));
  return seed;
}

/// A seeded stream; the same numbers on every machine and with every standard library.
class Random {
 public:
  explicit constexpr Random(std::uint64_t seed) : state_{mixed(seed)} {}

  constexpr std::uint64_t bits() { return mixed(state_ += 0x9e3779b97f4a7c15u); }

  /// Uniform in [0, 1).
  constexpr double uniform() { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }

  /// Uniform in [low, high).
  constexpr double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// Uniform in 0 .. n-1, n >= 1.
  constexpr std::uint64_t below(std::uint64_t n) {
    return static_cast<std::uint64_t>(uniform() * static_cast<double>(n));
  }

 private:
  std::uint64_t state_;
};

}  // namespace furrow
