// Evaluated by recursion over nodes that lie in one vector, which the depth of
// parsed formulas bounds. Operations are those of IEEE 754 or of sim/maths, one
// by one in the order of the text, so that bits are the same everywhere.
//
// Every value on the way is a finite number, which is checked where it is made:
// the first that is none is told with its place, and what is left to do then
// comes to nothing. So infinities never reach a comparison, where they would
// turn into plausible numbers.

#include "runtime/formula/formula.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "sim/maths/arc.h"
#include "sim/maths/exponential.h"
#include "sim/maths/hypot.h"
#include "sim/maths/sine.h"

namespace plsc {

namespace {

class Evaluator {
 public:
  Evaluator(const Formula& formula, std::span<const double> quantities)
      : formula_(formula), quantities_(quantities) {}

  double Of(std::size_t index) {
    const FormulaNode& node = formula_.nodes[index];
    const double value = Raw(node);
    if (problem_ == nullptr && !std::isfinite(value)) {
      problem_ = WhyNot(node);
      node_ = index;
    }
    return problem_ == nullptr ? value : 0;
  }

  FormulaValue Finish(double value) const { return {value, problem_, node_}; }

 private:
  double Operand(const FormulaNode& node, std::size_t i) {
    assert(i < node.count);
    return problem_ == nullptr ? Of(formula_.operands[node.first + i]) : 0;
  }
  bool Holds(const FormulaNode& node, std::size_t i) {
    return Operand(node, i) != 0;
  }

  double Raw(const FormulaNode& node) {
    using enum FormulaOp;
    switch (node.op) {
      case kNumber:
      case kTruth:
        return node.number;
      case kQuantity:
        return quantities_[node.quantity];
      case kNot:
        return Holds(node, 0) ? 0 : 1;
      case kAnd:
        return Holds(node, 0) && Holds(node, 1) ? 1 : 0;
      case kOr:
        return Holds(node, 0) || Holds(node, 1) ? 1 : 0;
      case kChoice:
        return Operand(node, Holds(node, 0) ? 1 : 2);
      case kMin:
      case kMax:
        return Extreme(node);
      default:
        break;
    }
    const double a = Operand(node, 0);
    if (node.count == 1) return OfOne(node.op, a);
    const double b = Operand(node, 1);
    if (node.op == kClamp) return std::min(std::max(a, b), Operand(node, 2));
    return OfTwo(node.op, a, b);
  }

  double Extreme(const FormulaNode& node) {
    double extreme = Operand(node, 0);
    for (std::size_t i = 1; i < node.count; ++i) {
      const double other = Operand(node, i);
      extreme = node.op == FormulaOp::kMin ? std::min(extreme, other)
                                           : std::max(extreme, other);
    }
    return extreme;
  }

  static double OfOne(FormulaOp op, double a) {
    using enum FormulaOp;
    switch (op) {
      case kNegate:
        return -a;
      case kAbs:
        return std::abs(a);
      case kSqrt:
        return std::sqrt(a);
      case kExp:
        return Exp(a);
      case kLog:
        return Log(a);
      case kSin:
        return Sin(a);
      case kCos:
        return Cos(a);
      default:
        assert(false);
        return 0;
    }
  }

  static double OfTwo(FormulaOp op, double a, double b) {
    using enum FormulaOp;
    switch (op) {
      case kAdd:
        return a + b;
      case kSubtract:
        return a - b;
      case kMultiply:
        return a * b;
      case kDivide:
        return a / b;
      case kLess:
        return a < b ? 1 : 0;
      case kLessEqual:
        return a <= b ? 1 : 0;
      case kGreater:
        return a > b ? 1 : 0;
      case kGreaterEqual:
        return a >= b ? 1 : 0;
      case kEqual:
        return a == b ? 1 : 0;
      case kNotEqual:
        return a != b ? 1 : 0;
      case kAtan2:
        return Atan2(a, b);
      case kHypot:
        return Hypot(a, b);
      default:
        assert(false);
        return 0;
    }
  }

  const char* WhyNot(const FormulaNode& node) {
    using enum FormulaOp;
    switch (node.op) {
      case kQuantity:
        return "nothing is known of a quantity";
      case kDivide:
        return Operand(node, 1) == 0 ? "division by 0"
                                     : "a number beyond all that are counted";
      case kSqrt:
        return "root of a negative number";
      case kLog:
        return "logarithm of a number that is not positive";
      default:
        return "a number beyond all that are counted";
    }
  }

  const Formula& formula_;
  std::span<const double> quantities_;
  const char* problem_ = nullptr;
  std::size_t node_ = 0;
};

}  // namespace

FormulaValue Formula::Evaluate(std::span<const double> quantities) const {
  return Evaluate(nodes.size() - 1, quantities);
}

FormulaValue Formula::Evaluate(std::size_t node,
                               std::span<const double> quantities) const {
  Evaluator evaluator(*this, quantities);
  const double value = evaluator.Of(node);
  return evaluator.Finish(value);
}

bool Formula::Uses(std::size_t quantity) const {
  return std::any_of(nodes.begin(), nodes.end(), [&](const FormulaNode& node) {
    return node.op == FormulaOp::kQuantity && node.quantity == quantity;
  });
}

}  // namespace plsc
