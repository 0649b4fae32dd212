#pragma once

// Text to the tree of a formula: arithmetic, comparisons and choices between
// names and numbers, "speed > 0 ? speed : speed * 0.1". Beside the language of
// genotypes, whose clauses have its words; no meaning: which names there are,
// and what has which type, is runtime/formula's business.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/result.h"

namespace plsc {

/// One part of a formula: a leaf, or an operator with its operands.
struct FormulaPart {
  enum class Kind : std::uint8_t {
    kNumber,  ///< `number`
    kTruth,   ///< True or False: `number` is 1 or 0
    kName,    ///< the text of `name`
    kCall,    ///< `name` of all operands
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
    kChoice,  ///< a ? b : c
  };

  Kind kind = Kind::kNumber;
  Span span;  ///< in the formula's text, with all operands
  Span name;
  double number = 0;
  std::vector<std::size_t> operands;  ///< indices of parts before this one
};

struct FormulaTree {
  std::string text;
  std::vector<FormulaPart> parts;  ///< the last one is the whole

  std::string_view Text(Span span) const {
    return std::string_view(text).substr(span.begin, span.end - span.begin);
  }
};

/// Longest text, and deepest nesting of parentheses and choices. Whoever walks
/// a tree may do so by recursion.
inline constexpr std::size_t kMaxFormulaLength = 2000;
inline constexpr int kMaxFormulaDepth = 50;

/// Places of diagnostics are in `text`. The first error ends it.
Result<FormulaTree> ParseFormula(std::string_view text);

}  // namespace plsc
