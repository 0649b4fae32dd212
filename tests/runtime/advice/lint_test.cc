#include "runtime/advice/lint.h"

#include <catch2/catch.hpp>

#include "runtime/develop/derive.h"
#include "runtime/develop/growth.h"

namespace plsc {
namespace {

constexpr const char* kGrowing =
    "plsc 1\nalphabet own { replaceable X; terminal a }\naxiom X\n"
    "sense hot: bool\nsense wet: bool\niterations 40\n"
    "rule X -> if hot = True then { X X a X }\n"
    "rule X -> if hot = False then { X a }\n";

TEST_CASE("Growth is told with its place, its cause and its environments",
          "[lint]") {
  const Source source("a", kGrowing);
  const auto compiled = CompileWithMap(source);
  REQUIRE(compiled);
  const std::vector<Diagnostic> found = Lint({&*compiled, 1}, source);
  REQUIRE(found.size() == 1);
  CHECK(found[0].code == Code::kMayGrowTooLong);
  CHECK(source.PositionOf(found[0].span.begin).line == 6);
  CHECK(found[0].message ==
        "when hot = True, development would produce 18236498188585393201 "
        "symbols, and the limit is 1048576");
  CHECK(found[0].label == "each 'X' becomes 4 symbols, 3 of them 'X' again");
  CHECK(found[0].notes ==
        std::vector<std::string>{"too long in 1 of 2 environments"});
}

TEST_CASE("An environment in which it grows too long is an error", "[lint]") {
  const Source source("a", kGrowing);
  const auto compiled = CompileWithMap(source);
  REQUIRE(compiled);
  const Genotype& genotype = compiled->program.genotype;
  const ActiveRules active = Regulate(genotype, {{1, 0}});
  const Diagnostic error =
      GrowthError(*compiled, active, DerivedLength(genotype, active), "summer");
  CHECK(error.code == Code::kTooLongString);
  CHECK(error.severity == Severity::kError);
  CHECK(error.message.starts_with("in summer, development would produce"));
}

TEST_CASE("Warnings are sorted by their place", "[lint]") {
  const Source source(
      "a",
      "plsc 1 alphabet plasticoding 1 sense hot: bool iterations 1\n"
      "rule T -> if hot = True then { B }\n"
      "rule C -> if hot = True then { C B }\n");
  const auto compiled = CompileWithMap(source);
  REQUIRE(compiled);
  std::string codes;
  for (const Diagnostic& warning : Lint({&*compiled, 1}, source))
    codes += std::string(NumberOf(warning.code)) + " ";
  CHECK(codes == "W3003 W4002 W3003 W4002 ");
}

}  // namespace
}  // namespace plsc
