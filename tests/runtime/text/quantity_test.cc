#include "runtime/text/quantity.h"

#include <catch2/catch.hpp>
#include <numbers>
#include <vector>

namespace plsc {

TEST_CASE("Quantities are read in SI", "[yaml]") {
  struct Row {
    const char* text;
    Dimension dimension;
    double expected;
  };
  for (const Row& row : std::vector<Row>{
           {"50", Dimension::kTime, 50},
           {"50 s", Dimension::kTime, 50},
           {"200ms", Dimension::kTime, 0.2},
           {"1.5 min", Dimension::kTime, 90},
           {"3 cm", Dimension::kLength, 0.03},
           {"30 mm", Dimension::kLength, 0.03},
           {"-0.03 m", Dimension::kLength, -0.03},
           {"180 deg", Dimension::kAngle, std::numbers::pi},
           {"0.5 rad", Dimension::kAngle, 0.5},
           {"90 deg/s", Dimension::kAngularSpeed, std::numbers::pi / 2},
           {"1e5", Dimension::kNumber, 100000},
           {".5", Dimension::kNumber, 0.5},
           {"0.17658 N m", Dimension::kTorque, 0.17658}}) {
    CAPTURE(row.text);
    const ParsedQuantity parsed = ParseQuantity(row.text, {row.dimension});
    REQUIRE_FALSE(parsed.error);
    CHECK(parsed.value == row.expected);
  }
}

TEST_CASE("What is no such quantity is explained", "[yaml]") {
  using enum QuantityError::Kind;
  struct Row {
    const char* why;
    const char* text;
    Quantity quantity;
    QuantityError::Kind kind;
    const char* message;
    const char* help;
  };
  const std::vector<Row> rows = {
      {"a length is no time",
       "50 m",
       {Dimension::kTime},
       kUnit,
       "expected a time in s, ms or min, found 'm'",
       "write it as in '50 s'"},
      {"angles need a unit",
       "5",
       {Dimension::kAngle},
       kUnit,
       "expected an angle with its unit: deg or rad",
       "write '5 deg'"},
      {"a share has no unit",
       "0.5 m",
       {Dimension::kNumber},
       kUnit,
       "expected a number without a unit, found 'm'",
       "write '0.5'"},
      {"a word",
       "fast",
       {Dimension::kTime},
       kNotANumber,
       "expected a time, found 'fast'",
       "write it as in '50 s'"},
      {"not a number",
       "nan",
       {Dimension::kTime},
       kNotANumber,
       "expected a time, found 'nan'",
       "write it as in '50 s'"},
      {"infinite",
       "-inf",
       {Dimension::kNumber},
       kNotANumber,
       "expected a number, found '-inf'",
       "write it as in '0.5'"},
      {"YAML's not a number",
       ".nan",
       {Dimension::kNumber},
       kNotANumber,
       "expected a number, found '.nan'",
       "write it as in '0.5'"},
      {"hexadecimal",
       "0x10",
       {Dimension::kNumber},
       kUnit,
       "expected a number without a unit, found 'x10'",
       "write '0'"},
      {"too large for a double",
       "1e400 s",
       {Dimension::kTime},
       kRange,
       "1e400 does not fit a 64-bit floating-point number",
       ""},
      {"below the range",
       "-1 s",
       {Dimension::kTime, 0, 60},
       kRange,
       "expected at least 0 s and at most 60 s, found -1 s",
       ""},
      {"an open limit",
       "0",
       {Dimension::kTime, 0, 60, true},
       kRange,
       "expected more than 0 s and at most 60 s, found 0 s",
       ""},
      {"in the unit of the range",
       "95 deg",
       {Dimension::kAngle, 0, std::numbers::pi / 2},
       kRange,
       "expected at least 0 deg and at most 90 deg, found 95 deg",
       ""}};
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const ParsedQuantity parsed = ParseQuantity(row.text, row.quantity);
      REQUIRE(parsed.error);
      CHECK(parsed.error->kind == row.kind);
      CHECK(parsed.error->message == row.message);
      CHECK(parsed.error->help == row.help);
    }
  }
}

TEST_CASE("Printed quantities read back bit for bit", "[yaml]") {
  CHECK(PrintQuantity(5 * std::numbers::pi / 180, Dimension::kAngle) ==
        "5 deg");
  CHECK(PrintQuantity(0.7853982, Dimension::kAngle) == "0.7853982 rad");
  CHECK(PrintQuantity(0.03, Dimension::kLength) == "0.03 m");
  CHECK(PrintQuantity(1e7 / 3, Dimension::kViscosity) ==
        "3333333.3333333335 N s/m");
  // Awkward angles and numbers, of which some print as radians.
  for (int i = 1; i < 2000; ++i) {
    const double value = i * 0.000785398163397448;
    for (const Dimension dimension :
         {Dimension::kAngle, Dimension::kTime, Dimension::kNumber}) {
      const std::string text = PrintQuantity(value, dimension);
      CAPTURE(text);
      const ParsedQuantity parsed = ParseQuantity(text, {dimension});
      REQUIRE_FALSE(parsed.error);
      REQUIRE(parsed.value == value);
    }
  }
}

}  // namespace plsc
