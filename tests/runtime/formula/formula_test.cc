#include "runtime/formula/formula.h"

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "runtime/formula/quantities.h"
#include "runtime/formula/random_formula.h"
#include "runtime/formula/read_formula.h"

namespace plsc {
namespace {

std::vector<double> Zeros() {
  return std::vector<double>(Quantities().size(), 0);
}

std::vector<double> DrawValues(std::mt19937& random) {
  // Ones that meet, and that are as far apart as doubles are.
  const double some[] = {0, -1, 0.25, 1, 7, 1e-300, -1e200, 1e300};
  std::vector<double> values;
  for (std::size_t i = 0; i < Quantities().size(); ++i)
    values.push_back(random() % 3 == 0
                         ? some[random() % 8]
                         : static_cast<double>(random()) / 1e9 - 2);
  return values;
}

TEST_CASE("Random formulas come to what they mean, bit for bit", "[formula]") {
  int numbers = 0, problems = 0, refused = 0;
  for (std::uint32_t seed = 1; seed <= 2000; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const test::RandomFormula drawn = test::DrawNumber(random, 5);
    INFO(drawn.text);
    const Result<Formula> formula = ReadFormula(drawn.text);
    if (!formula) {
      // Too long, or what can be no number: it must be so for any values.
      ++refused;
      for (const Diagnostic& problem : formula.diagnostics())
        CHECK(
            (problem.code == Code::kNoNumber || problem.code == Code::kLimit));
      continue;
    }
    const Result<Formula> again = ReadFormula(PrintFormula(*formula));
    REQUIRE(again);
    CHECK(*again == *formula);
    for (int i = 0; i < 5; ++i) {
      const std::vector<double> values = DrawValues(random);
      const std::optional<double> expected = drawn.value(values);
      const FormulaValue value = formula->Evaluate(values);
      REQUIRE((value.problem == nullptr) == expected.has_value());
      ++(expected ? numbers : problems);
      if (expected)
        CHECK(std::bit_cast<std::uint64_t>(value.value) ==
              std::bit_cast<std::uint64_t>(*expected));
    }
  }
  // All of it happened.
  CHECK(numbers > 2000);
  CHECK(problems > 500);
  CHECK(refused > 10);
}

TEST_CASE("What is no number is told with its place", "[formula]") {
  struct Row {
    const char* formula;
    double speed;
    const char* problem;  // nullptr: there is none
  };
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  const Row rows[] = {
      {"1 + 2 / speed", 0, "division by 0 in '2 / speed'"},
      {"speed > 0 ? 2 / speed : 0", 0, nullptr},
      {"speed > 0 and 1 / speed > 2 ? 1 : 0", 0, nullptr},
      {"1 / speed > 2 ? 1 : 0", 0, "division by 0 in '1 / speed'"},
      {"sqrt(speed)", -1, "root of a negative number in 'sqrt(speed)'"},
      {"log(speed)", 0,
       "logarithm of a number that is not positive in 'log(speed)'"},
      {"exp(speed * 100)", 100,
       "a number beyond all that are counted in 'exp(speed * 100)'"},
      {"min(speed, 3)", unknown, "nothing is known of a quantity in 'speed'"},
      {"False and speed > 1 ? 1 : 2", unknown, nullptr},
  };
  for (const Row& row : rows) {
    INFO(row.formula);
    const Result<Formula> formula = ReadFormula(row.formula);
    REQUIRE(formula);
    std::vector<double> values = Zeros();
    values[*FindQuantity("speed")] = row.speed;
    const FormulaValue value = formula->Evaluate(values);
    REQUIRE((value.problem != nullptr) == (row.problem != nullptr));
    if (row.problem != nullptr)
      CHECK(DescribeProblem(*formula, value) == row.problem);
  }
}

TEST_CASE("A formula knows what it asks about", "[formula]") {
  const Result<Formula> formula =
      ReadFormula("energy - displacement_velocity_hill");
  REQUIRE(formula);
  CHECK(formula->Uses(*FindQuantity("energy")));
  CHECK(formula->Uses(*FindQuantity("speed")));
  CHECK_FALSE(formula->Uses(*FindQuantity("size")));
}

}  // namespace
}  // namespace plsc
