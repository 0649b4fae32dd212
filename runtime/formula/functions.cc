#include "runtime/formula/functions.h"

#include <algorithm>
#include <cassert>

namespace plsc {

namespace {

// A name more is nearly always one too many.
constexpr std::size_t kMany = 100;

constexpr FormulaFunction kFunctions[] = {
    {FormulaOp::kAbs, "abs", "x", 1, 1, "x without its sign"},
    {FormulaOp::kMin, "min", "a, b, ...", 2, kMany, "the least"},
    {FormulaOp::kMax, "max", "a, b, ...", 2, kMany, "the greatest"},
    {FormulaOp::kClamp, "clamp", "x, low, high", 3, 3,
     "x, but at least low and at most high"},
    {FormulaOp::kSqrt, "sqrt", "x", 1, 1, "the root"},
    {FormulaOp::kExp, "exp", "x", 1, 1, "e to the power of x"},
    {FormulaOp::kLog, "log", "x", 1, 1, "the natural logarithm"},
    {FormulaOp::kSin, "sin", "x", 1, 1, "the sine of x rad"},
    {FormulaOp::kCos, "cos", "x", 1, 1, "the cosine of x rad"},
    {FormulaOp::kAtan2, "atan2", "y, x", 2, 2,
     "rad from the x axis to the point (x, y), -pi to pi"},
    {FormulaOp::kHypot, "hypot", "a, b", 2, 2, "sqrt(a * a + b * b)"},
};

}  // namespace

std::span<const FormulaFunction> FormulaFunctions() {
  return kFunctions;
}

const FormulaFunction* FindFormulaFunction(std::string_view name) {
  const auto* const found = std::find_if(
      std::begin(kFunctions), std::end(kFunctions),
      [&](const FormulaFunction& one) { return one.name == name; });
  return found == std::end(kFunctions) ? nullptr : found;
}

const FormulaFunction& FormulaFunctionOf(FormulaOp op) {
  assert(op >= FormulaOp::kAbs);
  return kFunctions[static_cast<std::size_t>(op) -
                    static_cast<std::size_t>(FormulaOp::kAbs)];
}

}  // namespace plsc
