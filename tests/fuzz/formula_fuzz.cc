// Any bytes give a formula or errors, each about a place of the text; what is
// read prints as a text that reads as the same formula, and comes to a finite
// number or says what keeps it from one.

#include <cmath>
#include <vector>

#include "fuzz/require.h"
#include "runtime/formula/quantities.h"
#include "runtime/formula/read_formula.h"

namespace {

using plsc::fuzz::Require;

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  const plsc::Source source = plsc::fuzz::AsSource(data, size);
  const plsc::Result<plsc::Formula> formula = plsc::ReadFormula(source.text());
  plsc::fuzz::RequireSound(formula.diagnostics(), source);
  if (!formula) return 0;
  const plsc::Result<plsc::Formula> again =
      plsc::ReadFormula(plsc::PrintFormula(*formula));
  Require(static_cast<bool>(again), "what is printed can be read");
  Require(*again == *formula, "what is printed means the same");
  std::vector<double> values(plsc::Quantities().size());
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = i % 5 == 0 ? 0 : static_cast<double>(i) / 7 - 3;
  const plsc::FormulaValue value = formula->Evaluate(values);
  if (value.problem == nullptr)
    Require(std::isfinite(value.value), "a value is a finite number");
  else
    Require(!plsc::DescribeProblem(*formula, value).empty(),
            "a problem is told");
  return 0;
}
