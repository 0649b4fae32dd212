#include "runtime/formula/functions.h"

#include <catch2/catch.hpp>
#include <set>
#include <string>
#include <vector>

#include "grammar/keywords.h"
#include "runtime/formula/formula.h"
#include "runtime/formula/quantities.h"
#include "runtime/formula/read_formula.h"

namespace plsc {
namespace {

TEST_CASE("Every function is found by its name and its operation",
          "[formula]") {
  for (const FormulaFunction& function : FormulaFunctions()) {
    CHECK(FindFormulaFunction(function.name) == &function);
    CHECK(&FormulaFunctionOf(function.op) == &function);
    CHECK_FALSE(FindQuantity(function.name));
    CHECK(function.least <= function.most);
  }
  CHECK(FindFormulaFunction("speed") == nullptr);
}

TEST_CASE("Functions come to what their sentences say", "[formula]") {
  const std::pair<const char*, double> rows[] = {
      {"abs(-2.5)", 2.5},
      {"min(3, 1, 2)", 1},
      {"max(3, 1, 2)", 3},
      {"clamp(5, 1, 4)", 4},
      {"clamp(0, 1, 4)", 1},
      {"clamp(2, 1, 4)", 2},
      {"sqrt(6.25)", 2.5},
      {"exp(1)", 2.718281828459045},
      {"log(10)", 2.302585092994046},
      {"sin(0)", 0},
      {"cos(pi)", -1},
      {"atan2(1, 0)", 1.5707963267948966},
      {"hypot(3, 4)", 5},
  };
  std::set<std::string> tried;
  for (const auto& [text, value] : rows) {
    INFO(text);
    const Result<Formula> formula = ReadFormula(text);
    REQUIRE(formula);
    CHECK(formula->Evaluate({}).value == Approx(value));
    const std::string whole = text;
    tried.insert(whole.substr(0, whole.find('(')));
  }
  CHECK(tried.size() == FormulaFunctions().size());
}

}  // namespace
}  // namespace plsc
