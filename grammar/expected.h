#pragma once

// A value, or the one reason why there is none, of whatever type says that: a
// Failure of the world's, the status that a command ends with.

#include <cassert>
#include <utility>
#include <variant>

namespace plsc {

template <typename T, typename E>
class [[nodiscard]] Expected {
 public:
  // Implicit, so that a function may `return value;` or `return error;`.
  Expected(T value) : held_(std::move(value)) {}  // NOLINT
  Expected(E error) : held_(std::move(error)) {}  // NOLINT

  explicit operator bool() const { return std::holds_alternative<T>(held_); }
  T& operator*() {
    assert(*this);
    return *std::get_if<T>(&held_);
  }
  const T& operator*() const {
    assert(*this);
    return *std::get_if<T>(&held_);
  }
  T* operator->() { return &**this; }
  const T* operator->() const { return &**this; }
  /// Only when there is no value.
  const E& error() const {
    assert(!*this);
    return *std::get_if<E>(&held_);
  }

 private:
  std::variant<T, E> held_;
};

}  // namespace plsc
