#include "runtime/formula/read_formula.h"

#include <catch2/catch.hpp>
#include <string>

namespace plsc {
namespace {

struct Wrong {
  const char* formula;
  Code code;
  const char* place;  // the text that it is about
  const char* message;
  const char* help;
};

const Wrong kWrong[] = {
    {"sped", Code::kUnknownQuantity, "sped", "no quantity is called 'sped'",
     ""},
    {"abz(speed)", Code::kUnknownQuantity, "abz", "no function is called 'abz'",
     ""},
    {"temperature", Code::kUnknownQuantity, "temperature",
     "no quantity is called 'temperature'", "docs/experiments.md"},
    {"abs", Code::kFormulaType, "abs",
     "expected a quantity, found the function 'abs'", "write abs(x)"},
    {"speed(2)", Code::kFormulaType, "speed",
     "expected a function, found the quantity 'speed'", "'*'"},
    {"clamp(speed, 1)", Code::kFormulaType, "clamp(speed, 1)",
     "expected 3 arguments of 'clamp', found 2", "clamp(x, low, high)"},
    {"abs(1, 2)", Code::kFormulaType, "abs(1, 2)",
     "expected 1 argument of 'abs', found 2", "abs(x)"},
    {"min(speed)", Code::kFormulaType, "min(speed)",
     "expected 2 arguments of 'min', found 1", "min(a, b, ...)"},
    {"speed > 0", Code::kFormulaType, "speed > 0",
     "expected a number, found True or False", "? 1 : 0"},
    {"True", Code::kFormulaType, "True",
     "expected a number, found True or False", ""},
    {"speed + (speed > 0)", Code::kFormulaType, "speed > 0",
     "expected a number, found True or False", ""},
    {"speed == True ? 1 : 2", Code::kFormulaType, "True", "expected a number",
     ""},
    {"speed ? 1 : 2", Code::kFormulaType, "speed",
     "expected True or False, found a number", "speed > 0"},
    {"not speed ? 1 : 2", Code::kFormulaType, "speed",
     "expected True or False, found a number", ""},
    {"speed > 0 ? 1 : True", Code::kFormulaType, "True",
     "expected a number, found True or False", ""},
    {"speed / 0", Code::kNoNumber, "0", "expected a divisor that is not 0", ""},
    {"speed / (2 - 2)", Code::kNoNumber, "2 - 2",
     "expected a divisor that is not 0", ""},
    {"speed > 0 ? 1 / 0 : 2", Code::kNoNumber, "0",
     "expected a divisor that is not 0", ""},
    {"sqrt(-1)", Code::kNoNumber, "sqrt(-1)",
     "expected a finite number, found root of a negative number in 'sqrt(-1)'",
     ""},
    {"speed + log(0)", Code::kNoNumber, "log(0)", "expected a finite number",
     ""},
    {"exp(1000)", Code::kNoNumber, "exp(1000)", "expected a finite number", ""},
    {"speed +", Code::kFormulaSyntax, "", "expected a number", ""},
};

TEST_CASE("What is wrong with a formula is told once, at its place",
          "[formula]") {
  for (const Wrong& wrong : kWrong) {
    INFO(wrong.formula);
    const std::string text = wrong.formula;
    const Result<Formula> formula = ReadFormula(text);
    REQUIRE_FALSE(formula);
    REQUIRE(formula.diagnostics().size() == 1);
    const Diagnostic& problem = formula.diagnostics()[0];
    CHECK(problem.code == wrong.code);
    CHECK(text.substr(problem.span.begin,
                      problem.span.end - problem.span.begin) == wrong.place);
    CHECK(problem.message.starts_with(wrong.message));
    CHECK(problem.help.find(wrong.help) != std::string::npos);
  }
}

TEST_CASE("All that is wrong is told in one go, with what was meant",
          "[formula]") {
  const Result<Formula> formula =
      ReadFormula("sped + enegry / 0 + (size > 1) + abs()");
  REQUIRE_FALSE(formula);  // the syntax comes first
  const Result<Formula> typed =
      ReadFormula("sped + energy / 0 + (size > 1) + abs(1, 2)");
  REQUIRE_FALSE(typed);
  REQUIRE(typed.diagnostics().size() == 4);
  REQUIRE(typed.diagnostics()[0].fixes.size() == 1);
  CHECK(typed.diagnostics()[0].fixes[0].replacement == "speed");
}

TEST_CASE("What is read can be printed and read again", "[formula]") {
  std::string chain = "pi";
  while (chain.size() < 240) chain += "+pi";
  const Result<Formula> long_enough = ReadFormula(chain);
  REQUIRE(long_enough);
  CHECK(ReadFormula(PrintFormula(*long_enough)));
  while (chain.size() < 900) chain += "+pi";
  const Result<Formula> too_long = ReadFormula(chain);
  REQUIRE_FALSE(too_long);
  CHECK(too_long.diagnostics()[0].code == Code::kLimit);
}

TEST_CASE("Constants of all kinds are numbers", "[formula]") {
  for (const char* text : {"3", "-0.5", "pi / 2", "1 - 1", "0 * speed",
                           "speed / (size + 0)", "speed / -1"})
    CHECK(ReadFormula(text));
}

}  // namespace
}  // namespace plsc
