#include <catch2/catch.hpp>
#include <vector>

#include "allocations.h"
#include "runtime/formula/formula.h"
#include "runtime/formula/quantities.h"
#include "runtime/formula/read_formula.h"

namespace plsc {
namespace {

TEST_CASE("Evaluating asks for no memory", "[memory]") {
  const Result<Formula> formula = ReadFormula(
      "max(speed, hypot(final_x, final_y), 3) > 1 ? -log(1 + energy) : 2");
  REQUIRE(formula);
  const std::vector<double> values(Quantities().size(), 0);
  const auto before = test::AllocationCount();
  const FormulaValue value = formula->Evaluate(values);
  CHECK(test::AllocationCount() == before);
  CHECK(value.problem == nullptr);
}

}  // namespace
}  // namespace plsc
