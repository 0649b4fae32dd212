#include "grammar/number.h"

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>
#include <string>

namespace plsc {
namespace {

using Limits = std::numeric_limits<double>;

TEST_CASE("A text is a number or it is none", "[number]") {
  CHECK(ParseNumber<double>("1") == 1);
  CHECK(ParseNumber<double>("-0.25") == -0.25);
  CHECK(ParseNumber<double>("1e-05") == 1e-5);
  CHECK(ParseNumber<double>("1.5e+16") == 1.5e16);
  CHECK(ParseNumber<double>(".5") == 0.5);
  for (const char* text :
       {"", "nan", "inf", "-inf", "infinity", "0x10", "1e999", "1e-999", "1,2",
        " 1", "1 ", "one", "+1", "1_000", "-", ".", "e5"}) {
    CAPTURE(text);
    CHECK_FALSE(ParseNumber<double>(text));
  }
}

TEST_CASE("Integers fit their types or are none", "[number]") {
  CHECK(ParseNumber<int>("-2147483648") == std::numeric_limits<int>::min());
  CHECK_FALSE(ParseNumber<int>("2147483648"));
  CHECK(ParseNumber<std::int64_t>("2147483648") == 2147483648);
  CHECK(ParseNumber<std::uint64_t>("18446744073709551615") ==
        std::numeric_limits<std::uint64_t>::max());
  CHECK_FALSE(ParseNumber<std::uint64_t>("18446744073709551616"));
  for (const char* text : {"", "-1", "1.0", "1e3", "+1", " 1", "1 "}) {
    CAPTURE(text);
    CHECK_FALSE(ParseNumber<std::uint64_t>(text));
  }
  CHECK(ParseHex("00fF") == 255);
  CHECK_FALSE(ParseHex("0xff"));
  CHECK_FALSE(ParseHex("10000000000000000"));
}

TEST_CASE("What a text begins with is told from what follows", "[number]") {
  using Number = LeadingNumber<double>;
  const Number angle = ReadNumber<double>("5e-1 deg");
  CHECK(angle.kind == Number::Kind::kFits);
  CHECK(angle.value == 0.5);
  CHECK(angle.length == 4);
  const Number unit = ReadNumber<double>("5em");
  CHECK(unit.value == 5);
  CHECK(unit.length == 1);
  const Number none = ReadNumber<double>("deg");
  CHECK(none.kind == Number::Kind::kNone);
  CHECK(none.length == 0);
  for (const char* text : {"1e999 m", "1e-999 m"}) {
    const Number far = ReadNumber<double>(text);
    CHECK(far.kind == Number::Kind::kOutOfRange);
    CHECK(far.value == 0);
    CHECK(far.length == std::string(text).find(' '));
  }
  CHECK(ReadNumber<double>("inf").kind == Number::Kind::kFits);
  CHECK(ReadNumber<int>("12abc").value == 12);
  CHECK(ReadNumber<int>("99999999999").kind ==
        LeadingNumber<int>::Kind::kOutOfRange);
}

TEST_CASE("The shortest text is printed, and where it has an exponent",
          "[number]") {
  struct Case {
    double value;
    const char* shortest;
    const char* plain;
  };
  for (const Case& one :
       {Case{0.1, "0.1", "0.1"},
        {-0.0, "-0", "-0"},
        {1, "1", "1"},
        {100000, "1e+05", "100000"},
        {123456, "123456", "123456"},
        {1e15, "1e+15", "1000000000000000"},
        {1e16, "1e+16", "1e+16"},
        {0.0001, "1e-04", "0.0001"},
        {0.001, "0.001", "0.001"},
        {1e-5, "1e-05", "1e-05"},
        {1152921504606846976, "1152921504606846976", "1.152921504606847e+18"},
        {Limits::max(), "1.7976931348623157e+308", "1.7976931348623157e+308"},
        {Limits::denorm_min(), "5e-324", "5e-324"}}) {
    CHECK(PrintNumber(one.value) == one.shortest);
    CHECK(PrintPlainNumber(one.value) == one.plain);
  }
  CHECK(PrintRoundedNumber(0.055499999999999994, 15) == "0.0555");
  CHECK(PrintRoundedNumber(123456789, 6) == "1.23457e+08");
  std::string text = "x = ";
  AppendNumber(2.5, &text);
  CHECK(text == "x = 2.5");
}

TEST_CASE(
    "Every double reads back from both of its texts, and as printf has it",
    "[number]") {
  constexpr unsigned kSeed = 15;
  CAPTURE(kSeed);
  std::mt19937_64 random(kSeed);
  for (int i = 0; i < 2000; ++i) {
    const auto value = std::bit_cast<double>(random());
    if (!std::isfinite(value)) continue;
    char exact[64];
    std::snprintf(exact, sizeof exact, "%.17g", value);
    const auto bits = std::bit_cast<std::uint64_t>(value);
    for (const std::string& text :
         {PrintNumber(value), PrintPlainNumber(value), std::string(exact)}) {
      CAPTURE(text);
      const auto read = ParseNumber<double>(text);
      REQUIRE(read);
      REQUIRE(std::bit_cast<std::uint64_t>(*read) == bits);
    }
  }
}

}  // namespace
}  // namespace plsc
