#include <catch2/catch.hpp>
#include <string>

#include "runtime/formula/formula.h"
#include "runtime/formula/read_formula.h"

namespace plsc {
namespace {

TEST_CASE("Formulas print with what is needed alone", "[formula]") {
  const std::pair<const char*, const char*> rows[] = {
      {"((speed))", "speed"},
      {"absolute_size", "size"},
      {"speed-( energy*2 )", "speed - energy * 2"},
      {"speed-(energy-2)", "speed - (energy - 2)"},
      {"(speed-energy)-2", "speed - energy - 2"},
      {"speed/(energy/2)", "speed / (energy / 2)"},
      {"(speed+1)*2", "(speed + 1) * 2"},
      {"-(speed+1)", "-(speed + 1)"},
      {"-(-speed)", "--speed"},
      {"2*(-speed)", "2 * -speed"},
      {"0.10", "0.1"},
      {"1e3", "1000"},
      {"min(speed,(2),3)", "min(speed, 2, 3)"},
      {"(speed>0)?(1):((speed<0)?2:3)", "speed > 0 ? 1 : speed < 0 ? 2 : 3"},
      {"((speed>0)?True:False)?1:2", "(speed > 0 ? True : False) ? 1 : 2"},
      {"(speed>0 ? 1 : 2) + 1", "(speed > 0 ? 1 : 2) + 1"},
      {"not (speed>0 or speed<-1) and True ? 1 : 2",
       "not (speed > 0 or speed < -1) and True ? 1 : 2"},
      {"speed>0 or (speed<1 or speed<2) ? 1 : 2",
       "speed > 0 or (speed < 1 or speed < 2) ? 1 : 2"},
  };
  for (const auto& [text, printed] : rows) {
    INFO(text);
    const Result<Formula> formula = ReadFormula(text);
    REQUIRE(formula);
    CHECK(PrintFormula(*formula) == printed);
    const Result<Formula> again = ReadFormula(printed);
    REQUIRE(again);
    CHECK(*again == *formula);
  }
}

}  // namespace
}  // namespace plsc
