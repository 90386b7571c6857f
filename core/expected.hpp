#pragma once
// A value, or the reason there is none. The surface is a subset of C++23 std::expected: once the
// compiler ships it, this file becomes two `using` lines and no caller changes.

#include "core/require.hpp"

#include <utility>
#include <variant>

namespace furrow {

template <class E>
struct Unexpected {
  E error;
};
template <class E>
Unexpected(E) -> Unexpected<E>;

template <class T, class E>
class [[nodiscard]] Expected {
 public:
  Expected(T value) : state_{std::in_place_index<0>, std::move(value)} {}
  Expected(Unexpected<E> why) : state_{std::in_place_index<1>, std::move(why.error)} {}

  bool has_value() const { return state_.index() == 0; }
  explicit operator bool() const { return has_value(); }

  /// @pre has_value()
  const T& operator*() const& {
    require(has_value(), "a value is read only where there is one");
    return *std::get_if<0>(&state_);
  }
  T& operator*() & {
    require(has_value(), "a value is read only where there is one");
    return *std::get_if<0>(&state_);
  }
  const T* operator->() const { return &**this; }
  T* operator->() { return &**this; }
  /// @pre !has_value()
  const E& error() const {
    require(!has_value(), "an error is read only where there is one");
    return *std::get_if<1>(&state_);
  }

 private:
  std::variant<T, E> state_;
};

}  // namespace furrow
