// Each operator says how tightly it binds and what its operands must at least
// bind like; parentheses stand where one binds less. The levels are those of
// grammar/formula_rules.

#include <fmt/format.h>

#include "grammar/number.h"
#include "runtime/formula/formula.h"
#include "runtime/formula/quantities.h"

namespace plsc {

namespace {

enum Level {
  kAnything,
  kDisjunction,
  kConjunction,
  kCondition,
  kComparison,
  kSum,
  kProduct,
  kFactor,
  kPrimary,
};

struct Infix {
  FormulaOp op;
  std::string_view sign;
  Level own, left, right;
};

constexpr Infix kInfixes[] = {
    {FormulaOp::kAdd, "+", kSum, kSum, kProduct},
    {FormulaOp::kSubtract, "-", kSum, kSum, kProduct},
    {FormulaOp::kMultiply, "*", kProduct, kProduct, kFactor},
    {FormulaOp::kDivide, "/", kProduct, kProduct, kFactor},
    {FormulaOp::kLess, "<", kComparison, kSum, kSum},
    {FormulaOp::kLessEqual, "<=", kComparison, kSum, kSum},
    {FormulaOp::kGreater, ">", kComparison, kSum, kSum},
    {FormulaOp::kGreaterEqual, ">=", kComparison, kSum, kSum},
    {FormulaOp::kEqual, "==", kComparison, kSum, kSum},
    {FormulaOp::kNotEqual, "!=", kComparison, kSum, kSum},
    {FormulaOp::kAnd, "and", kConjunction, kConjunction, kCondition},
    {FormulaOp::kOr, "or", kDisjunction, kDisjunction, kConjunction},
};

class FormulaPrinter {
 public:
  explicit FormulaPrinter(const Formula& formula) : formula_(formula) {}

  std::string Print(std::size_t index, Level least) const {
    const FormulaNode& node = formula_.nodes[index];
    const auto operand = [&](std::size_t i, Level level) {
      return Print(formula_.operands[node.first + i], level);
    };
    switch (node.op) {
      case FormulaOp::kNumber:
        return PrintPlainNumber(node.number);
      case FormulaOp::kTruth:
        return node.number != 0 ? "True" : "False";
      case FormulaOp::kQuantity:
        return std::string(Quantities()[node.quantity].name);
      case FormulaOp::kNegate:
        return Within("-" + operand(0, kFactor), kFactor, least);
      case FormulaOp::kNot:
        return Within("not " + operand(0, kCondition), kCondition, least);
      case FormulaOp::kChoice:
        return Within(fmt::format("{} ? {} : {}", operand(0, kDisjunction),
                                  operand(1, kAnything), operand(2, kAnything)),
                      kAnything, least);
      default:
        break;
    }
    for (const Infix& infix : kInfixes)
      if (infix.op == node.op)
        return Within(fmt::format("{} {} {}", operand(0, infix.left),
                                  infix.sign, operand(1, infix.right)),
                      infix.own, least);
    std::vector<std::string> arguments;
    for (std::size_t i = 0; i < node.count; ++i)
      arguments.push_back(operand(i, kAnything));
    return fmt::format("{}({})", FormulaFunctionOf(node.op).name,
                       fmt::join(arguments, ", "));
  }

 private:
  static std::string Within(const std::string& text, Level own, Level least) {
    return own < least ? "(" + text + ")" : text;
  }

  const Formula& formula_;
};

}  // namespace

std::string PrintFormula(const Formula& formula) {
  return FormulaPrinter(formula).Print(formula.nodes.size() - 1, kAnything);
}

std::string DescribeProblem(const Formula& formula, const FormulaValue& value) {
  return fmt::format("{} in '{}'", value.problem,
                     FormulaPrinter(formula).Print(value.node, kAnything));
}

}  // namespace plsc
