// One pass over the parts, each of which comes after its operands: a name is
// found, types are compared, and what is made of constants alone is evaluated,
// by the evaluator of lives, so that what it cannot give is said here already.
// A part that is wrong has no type, and nobody complains of it a second time.

#include "runtime/formula/read_formula.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <numbers>
#include <vector>

#include "grammar/formula.h"
#include "grammar/reporter.h"
#include "grammar/suggest.h"
#include "runtime/formula/quantities.h"

namespace plsc {

namespace {

using PartKind = FormulaPart::Kind;

enum class Type : std::uint8_t { kUnknown, kNumber, kTruth };

/// The name of a number.
constexpr std::string_view kPi = "pi";

struct Operator {
  PartKind kind;
  FormulaOp op;
  Type from, to;
};

constexpr Operator kOperators[] = {
    {PartKind::kNegate, FormulaOp::kNegate, Type::kNumber, Type::kNumber},
    {PartKind::kNot, FormulaOp::kNot, Type::kTruth, Type::kTruth},
    {PartKind::kAdd, FormulaOp::kAdd, Type::kNumber, Type::kNumber},
    {PartKind::kSubtract, FormulaOp::kSubtract, Type::kNumber, Type::kNumber},
    {PartKind::kMultiply, FormulaOp::kMultiply, Type::kNumber, Type::kNumber},
    {PartKind::kDivide, FormulaOp::kDivide, Type::kNumber, Type::kNumber},
    {PartKind::kLess, FormulaOp::kLess, Type::kNumber, Type::kTruth},
    {PartKind::kLessEqual, FormulaOp::kLessEqual, Type::kNumber, Type::kTruth},
    {PartKind::kGreater, FormulaOp::kGreater, Type::kNumber, Type::kTruth},
    {PartKind::kGreaterEqual, FormulaOp::kGreaterEqual, Type::kNumber,
     Type::kTruth},
    {PartKind::kEqual, FormulaOp::kEqual, Type::kNumber, Type::kTruth},
    {PartKind::kNotEqual, FormulaOp::kNotEqual, Type::kNumber, Type::kTruth},
    {PartKind::kAnd, FormulaOp::kAnd, Type::kTruth, Type::kTruth},
    {PartKind::kOr, FormulaOp::kOr, Type::kTruth, Type::kTruth},
};

std::vector<std::string_view> KnownNames(bool with_quantities) {
  std::vector<std::string_view> names;
  for (const FormulaFunction& one : FormulaFunctions())
    names.push_back(one.name);
  if (!with_quantities) return names;
  const auto quantities = QuantityNames();
  names.insert(names.begin(), quantities.begin(), quantities.end());
  names.push_back(kPi);
  return names;
}

class Reading {
 public:
  explicit Reading(const FormulaTree& tree) : tree_(tree) {}

  Result<Formula> Read() {
    for (const FormulaPart& part : tree_.parts) Add(part);
    Expect(tree_.parts.size() - 1, Type::kNumber);
    if (errors_.has_errors()) return errors_.Take();
    return std::move(formula_);
  }

 private:
  void Add(const FormulaPart& part) {
    FormulaNode node;
    node.first = formula_.operands.size();
    node.count = part.operands.size();
    formula_.operands.insert(formula_.operands.end(), part.operands.begin(),
                             part.operands.end());
    const std::size_t before = errors_.diagnostics().size();
    const Type type = Resolve(part, node);
    const bool is_right =
        errors_.diagnostics().size() == before && type != Type::kUnknown &&
        std::all_of(part.operands.begin(), part.operands.end(),
                    [&](std::size_t i) { return types_[i] != Type::kUnknown; });
    formula_.nodes.push_back(node);
    types_.push_back(is_right ? type : Type::kUnknown);
    is_constant_.push_back(
        is_right && node.op != FormulaOp::kQuantity &&
        std::all_of(part.operands.begin(), part.operands.end(),
                    [&](std::size_t i) { return is_constant_[i]; }));
    if (is_right) CheckNumber(part);
  }

  Type Resolve(const FormulaPart& part, FormulaNode& node) {
    switch (part.kind) {
      case PartKind::kNumber:
        node.number = part.number;
        return Type::kNumber;
      case PartKind::kTruth:
        node.op = FormulaOp::kTruth;
        node.number = part.number;
        return Type::kTruth;
      case PartKind::kName:
        return ResolveName(part, node);
      case PartKind::kCall:
        return ResolveCall(part, node);
      case PartKind::kChoice:
        return ResolveChoice(part, node);
      default:
        break;
    }
    const auto* const found = std::find_if(
        std::begin(kOperators), std::end(kOperators),
        [&](const Operator& one) { return one.kind == part.kind; });
    assert(found != std::end(kOperators));
    node.op = found->op;
    for (const std::size_t operand : part.operands)
      Expect(operand, found->from);
    return found->to;
  }

  Type ResolveName(const FormulaPart& part, FormulaNode& node) {
    const std::string_view name = tree_.Text(part.name);
    if (name == kPi) {
      node.number = std::numbers::pi;
      return Type::kNumber;
    }
    if (const auto quantity = FindQuantity(name)) {
      node.op = FormulaOp::kQuantity;
      node.quantity = *quantity;
      return Type::kNumber;
    }
    if (const FormulaFunction* function = FindFormulaFunction(name)) {
      errors_
          .Report(
              Code::kFormulaType, part.name,
              fmt::format("expected a quantity, found the function '{}'", name))
          .WithHelp(fmt::format("write {}({})", name, function->arguments));
      return Type::kUnknown;
    }
    Unknown(part.name, "no quantity is called", KnownNames(true));
    return Type::kUnknown;
  }

  Type ResolveCall(const FormulaPart& part, FormulaNode& node) {
    const std::string_view name = tree_.Text(part.name);
    const FormulaFunction* const function = FindFormulaFunction(name);
    if (function == nullptr) {
      if (FindQuantity(name) || name == kPi)
        errors_
            .Report(Code::kFormulaType, part.name,
                    fmt::format("expected a function, found the quantity '{}'",
                                name))
            .WithHelp("a product needs its '*'");
      else
        Unknown(part.name, "no function is called", KnownNames(false));
      return Type::kUnknown;
    }
    node.op = function->op;
    const std::size_t count = part.operands.size();
    if (count < function->least || count > function->most)
      errors_
          .Report(
              Code::kFormulaType, part.span,
              fmt::format(
                  "expected {} {} of '{}', found {}",
                  count < function->least ? function->least : function->most,
                  function->most == 1 ? "argument" : "arguments", name, count))
          .WithHelp(fmt::format("write {}({}): {}", name, function->arguments,
                                function->meaning));
    for (const std::size_t operand : part.operands)
      Expect(operand, Type::kNumber);
    return Type::kNumber;
  }

  Type ResolveChoice(const FormulaPart& part, FormulaNode& node) {
    node.op = FormulaOp::kChoice;
    Expect(part.operands[0], Type::kTruth);
    const Type type = types_[part.operands[1]];
    if (type != Type::kUnknown) Expect(part.operands[2], type);
    return type;
  }

  void Expect(std::size_t part, Type type) {
    if (types_[part] == type || types_[part] == Type::kUnknown) return;
    const bool is_number = type == Type::kNumber;
    errors_
        .Report(Code::kFormulaType, tree_.parts[part].span,
                is_number ? "expected a number, found True or False"
                          : "expected True or False, found a number")
        .WithHelp(is_number ? "write 'condition ? 1 : 0'"
                            : "compare it, as in 'speed > 0'");
    types_[part] = Type::kUnknown;
  }

  void Unknown(Span place, std::string_view what,
               const std::vector<std::string_view>& known) {
    const std::string_view name = tree_.Text(place);
    Diagnostic problem(Code::kUnknownQuantity, place,
                       fmt::format("{} '{}'", what, name));
    if (!AddSuggestion(name, known, &problem))
      problem.WithHelp("docs/experiments.md lists quantities and functions");
    errors_.Add(std::move(problem));
  }

  /// What can be none, whatever the quantities are. Once for each: what is made
  /// of it has no type any more.
  void CheckNumber(const FormulaPart& part) {
    const std::size_t own = formula_.nodes.size() - 1;
    const bool is_division = part.kind == PartKind::kDivide;
    if (is_division && is_constant_[part.operands[1]] &&
        formula_.Evaluate(part.operands[1], {}).value == 0) {
      errors_.Report(Code::kNoNumber, tree_.parts[part.operands[1]].span,
                     "expected a divisor that is not 0");
      types_[own] = Type::kUnknown;
      return;
    }
    if (!is_constant_[own]) return;
    const FormulaValue value = formula_.Evaluate(own, {});
    if (value.problem == nullptr) return;
    errors_.Report(Code::kNoNumber, part.span,
                   fmt::format("expected a finite number, found {}",
                               DescribeProblem(formula_, value)));
    types_[own] = Type::kUnknown;
  }

  const FormulaTree& tree_;
  Formula formula_;
  std::vector<Type> types_;        // by part
  std::vector<bool> is_constant_;  // by part: it knows no quantity
  Reporter errors_;
};

}  // namespace

Result<Formula> ReadFormula(std::string_view text) {
  const Result<FormulaTree> tree = ParseFormula(text);
  if (!tree) return tree.diagnostics();
  Result<Formula> formula = Reading(*tree).Read();
  // Runs keep what is printed, which may be longer.
  if (formula && PrintFormula(*formula).size() > kMaxFormulaLength)
    return Diagnostic(Code::kLimit, {},
                      fmt::format("a formula has at most {} characters as it "
                                  "is printed",
                                  kMaxFormulaLength));
  return formula;
}

}  // namespace plsc
