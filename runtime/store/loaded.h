#pragma once

// A value that was read from a store, or why it could not be.

#include <cassert>
#include <optional>
#include <string>
#include <utility>

namespace plsc {

template <typename T>
class [[nodiscard]] Loaded {
 public:
  Loaded(T value) : value_(std::move(value)) {}  // NOLINT: as Result
  static Loaded Failed(const std::string& failure) {
    Loaded loaded;
    loaded.failure_ = failure;
    return loaded;
  }

  explicit operator bool() const { return value_.has_value(); }
  T& operator*() {
    assert(value_);
    return *value_;
  }
  const T& operator*() const {
    assert(value_);
    return *value_;
  }
  T* operator->() { return &**this; }
  const T* operator->() const { return &**this; }
  /// "'run.sqlite' is damaged: ...": empty when there is a value.
  const std::string& failure() const { return failure_; }

 private:
  Loaded() = default;

  std::optional<T> value_;
  std::string failure_;
};

}  // namespace plsc
