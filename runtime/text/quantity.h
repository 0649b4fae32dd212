#pragma once

// Quantities as people write them in YAML: "50 s", "3 cm", "5 deg". A bare
// number is SI; angles must name their unit, because a bare 5 is as easily
// meant one way as the other. Knows no YAML.

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace plsc {

/// The paper gives Speed and Fitness in cm/s; all numbers inside are SI.
inline constexpr double kCentimetres = 100;

enum class Dimension : std::uint8_t {
  kNumber,  ///< without a unit
  kTime,
  kLength,
  kAngle,
  kAngularSpeed,
  kFrequency,
  kRate,
  kAcceleration,
  kTorque,
  kStiffness,
  kViscosity,
  kSlip,
  kSpeed,
};

/// What a key accepts: its dimension and its range, in SI.
struct Quantity {
  Dimension dimension = Dimension::kNumber;
  double low = -std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::max();
  bool is_low_excluded = false;
  std::optional<double> usual{};  ///< its default, to be shown as an example
};

/// What is wrong with a text, and how to mend it; or the value in SI.
struct QuantityError {
  enum class Kind : std::uint8_t { kNotANumber, kUnit, kRange };
  Kind kind = Kind::kNotANumber;
  std::string message;        ///< expected before found
  std::string help;           ///< what it tells to write is always accepted
  std::string replacement{};  ///< what was meant, if that is clear
};
struct ParsedQuantity {
  double value = 0;
  std::optional<QuantityError> error;
};
ParsedQuantity ParseQuantity(std::string_view text, const Quantity& quantity);

/// Shortest text that ParseQuantity reads back to the same value, with a unit
/// where there is one: "50 s", "5 deg" (rad where degrees would not do).
std::string PrintQuantity(double value, Dimension dimension);

/// One that is in the range, to be shown: "50 s", "0.1 s".
std::string ExampleOf(const Quantity& quantity);

/// "a time", "an angle".
std::string_view DimensionName(Dimension dimension);

/// For documentation and messages: "s, ms or min"; empty for kNumber.
std::string AcceptedUnits(Dimension dimension);

}  // namespace plsc
