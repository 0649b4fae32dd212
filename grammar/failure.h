#pragma once

// Why something was not done that depends on the world: a file, a disk, another
// process. The text is for the user, and nobody's decision depends on it; the
// kind is for a caller who has something else to do then.

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace plsc {

struct Failure {
  enum class Kind : std::uint8_t {
    kOther,
    kMalformed,  ///< a file that makes no sense, and more is not known of it
    kChanged,    ///< somebody wrote meanwhile: trying again may help
  };

  // Implicit, so that a function may `return fmt::format(...);` and
  // `return "...";`.
  Failure(std::string why, Kind of = Kind::kOther)  // NOLINT
      : text(std::move(why)), kind(of) {}
  Failure(const char* why) : Failure(std::string(why)) {}  // NOLINT

  std::string
      text;  ///< "cannot write to 'run.sqlite': No space left on device"
  Kind kind;

  friend bool operator==(const Failure&, const Failure&) = default;
};

/// What went wrong, or nothing.
using MaybeFailure = std::optional<Failure>;

}  // namespace plsc
