#include "runtime/formula/formula_yaml.h"

#include <utility>

#include "runtime/formula/read_formula.h"

namespace plsc {

std::optional<Formula> ReadFormula(const YamlValue& value) {
  const auto text = value.Text("a formula, such as speed - 0.01 * energy");
  if (!text) return std::nullopt;
  Result<Formula> formula = ReadFormula(*text);
  if (formula) return std::move(*formula);
  for (const Diagnostic& problem : formula.diagnostics())
    value.ReportPart(problem);
  return std::nullopt;
}

}  // namespace plsc
