#pragma once

// A checked formula over the quantities of a season (quantities.h), to be
// evaluated thousands of times: the same bits on every machine.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/formula/functions.h"

namespace plsc {

struct FormulaNode {
  FormulaOp op = FormulaOp::kNumber;
  double number = 0;         ///< of kNumber; 1 or 0 of kTruth
  std::size_t quantity = 0;  ///< of kQuantity: its index
  std::size_t first = 0;     ///< of its operands in Formula::operands
  std::size_t count = 0;

  friend bool operator==(const FormulaNode&, const FormulaNode&) = default;
};

/// A number, or why there is none and which node had none.
struct FormulaValue {
  double value = 0;
  const char* problem = nullptr;
  std::size_t node = 0;
};

struct Formula {
  std::vector<FormulaNode> nodes;     ///< the last is the whole; never empty
  std::vector<std::size_t> operands;  ///< indices of nodes before their owner

  /// `quantities` has a value for each quantity, not a number where it is
  /// unknown. Only what decides is evaluated: one branch of a choice, 'and' and
  /// 'or' from the left. What is no finite number anywhere on the way is a
  /// problem, also where a later comparison would hide it. Asks for no memory.
  FormulaValue Evaluate(std::span<const double> quantities) const;
  /// Of one node, and what it is made of.
  FormulaValue Evaluate(std::size_t node,
                        std::span<const double> quantities) const;
  bool Uses(std::size_t quantity) const;

  friend bool operator==(const Formula&, const Formula&) = default;
};

/// One text for all equal formulas, with blanks and parentheses only where they
/// are needed; ReadFormula makes an equal one of it.
std::string PrintFormula(const Formula& formula);

/// Of a problem: "division by 0 in 'speed / energy'".
std::string DescribeProblem(const Formula& formula, const FormulaValue& value);

}  // namespace plsc
