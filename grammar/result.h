#pragma once

// A value, or the reasons why there is none. The way every stage reports that
// the user's text is wrong; no exception crosses a folder.

#include <cassert>
#include <optional>
#include <utility>
#include <vector>

#include "grammar/diagnostic.h"

namespace plsc {

/// Either a value (perhaps with warnings) or at least one error.
template <typename T>
class [[nodiscard]] Result {
 public:
  // Implicit, so that a function may `return value;` or `return diagnostic;`.
  Result(T value) : value_(std::move(value)) {}                 // NOLINT
  Result(Diagnostic error) : diagnostics_{std::move(error)} {}  // NOLINT
  Result(std::vector<Diagnostic> errors)                        // NOLINT
      : diagnostics_(std::move(errors)) {
    assert(!diagnostics_.empty());
  }
  Result(T value, std::vector<Diagnostic> warnings)
      : value_(std::move(value)), diagnostics_(std::move(warnings)) {}

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

  /// Errors when there is no value, else the warnings.
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  std::optional<T> value_;
  std::vector<Diagnostic> diagnostics_;
};

}  // namespace plsc
