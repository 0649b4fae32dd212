#pragma once

// The one door between numbers and their texts: the same everywhere, whatever
// the language of the system, and exact. A text is read to the nearest double,
// and printed is the shortest that reads back to the same one. Nothing else
// reads numbers out of texts (.ci/check_tree.py), so that a standard library
// without <charconv> for doubles is a matter of number.cc alone.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace plsc {

/// What a text begins with.
template <typename T>
struct LeadingNumber {
  enum class Kind : std::uint8_t {
    kNone,       ///< no number
    kFits,       ///< `value`
    kOutOfRange  ///< too large for a T, or, of doubles, too near to zero
  };
  Kind kind = Kind::kNone;
  T value = 0;
  std::size_t length = 0;  ///< bytes of it
};

/// "5 deg" is 5, of one byte. Signs are '-' only; doubles may have a fraction
/// and an exponent, or be inf or nan. T is double or an integer of 32 or 64
/// bits.
template <typename T>
LeadingNumber<T> ReadNumber(std::string_view text);

/// All of `text`, if it is a number that fits and is finite.
template <typename T>
std::optional<T> ParseNumber(std::string_view text);

/// Likewise to the base 16, in either case: "ff", "00FF".
std::optional<std::uint64_t> ParseHex(std::string_view digits);

/// The shortest, with an exponent where that is shorter: "0.1", "1e+05", "-0".
/// What genotypes are printed with.
std::string PrintNumber(double value);
void AppendNumber(double value, std::string* text);

/// With the same digits, but with an exponent only from 1e16 on and below 1e-4:
/// "0.1", "100000", "-0". What people read and tables hold.
std::string PrintPlainNumber(double value);

/// Likewise, with at most that many significant digits: not exact.
std::string PrintRoundedNumber(double value, int digits);

}  // namespace plsc
