#pragma once

// The functions that formulas know.

#include <cstdint>
#include <span>
#include <string_view>

namespace plsc {

/// What a node of a formula is. Functions last, in the order of
/// FormulaFunctions.
enum class FormulaOp : std::uint8_t {
  kNumber,
  kTruth,
  kQuantity,
  kNegate,
  kNot,
  kAdd,
  kSubtract,
  kMultiply,
  kDivide,
  kLess,
  kLessEqual,
  kGreater,
  kGreaterEqual,
  kEqual,
  kNotEqual,
  kAnd,
  kOr,
  kChoice,
  kAbs,
  kMin,
  kMax,
  kClamp,
  kSqrt,
  kExp,
  kLog,
  kSin,
  kCos,
  kAtan2,
  kHypot,
};

struct FormulaFunction {
  FormulaOp op;
  std::string_view name;
  std::string_view arguments;  ///< "x, low, high"
  std::size_t least = 1;       ///< arguments
  std::size_t most = 1;
  std::string_view meaning;  ///< a sentence without its end
};

/// All of numbers, to a number.
std::span<const FormulaFunction> FormulaFunctions();
/// nullptr when there is none.
const FormulaFunction* FindFormulaFunction(std::string_view name);
const FormulaFunction& FormulaFunctionOf(FormulaOp op);

}  // namespace plsc
