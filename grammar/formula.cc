// A formula is parsed in one go from left to right; where a must<> fails, that
// is the error, and there is only one: what follows a mistake in so short a
// text is seldom a second one. Operands lie on a stack until their operator has
// all of its own, so parts come in the order of evaluation, and each after its
// operands.
//
// Depth is bounded while parsing, as rules are recursive: a text of nothing but
// parentheses must not overflow anybody's stack. A chain of operators is as
// deep as it is long, which the text's length bounds.

#include "grammar/formula.h"

#include <fmt/format.h>

#include <cassert>
#include <utility>

#include "grammar/formula_rules.h"
#include "grammar/lookaround.h"
#include "grammar/number.h"

namespace plsc {

namespace {

namespace rules = grammar::formula;
using PartKind = FormulaPart::Kind;

struct FormulaError {
  Diagnostic diagnostic;
};

/// A call whose arguments are being read.
struct OpenCall {
  Span name;
  std::size_t first = 0;  // of its operands, in FormulaBuilder::open
};

struct FormulaBuilder {
  FormulaTree tree;
  std::vector<std::size_t> open;  // parts that no operator has taken yet
  std::vector<OpenCall> calls;
  std::vector<std::uint32_t> signs;  // where a '-' or 'not' stands
  Span name;                         // the latest
  int depth = 0;

  template <typename Input>
  Span SpanOf(const Input& in) const {
    const char* const base = tree.text.data();
    return {static_cast<std::uint32_t>(in.begin() - base),
            static_cast<std::uint32_t>(in.end() - base)};
  }
  void Push(FormulaPart part) {
    open.push_back(tree.parts.size());
    tree.parts.push_back(std::move(part));
  }
  /// One part of all open ones from `first` on.
  FormulaPart& Join(PartKind kind, std::size_t first) {
    FormulaPart part;
    part.kind = kind;
    part.operands.assign(open.begin() + static_cast<std::ptrdiff_t>(first),
                         open.end());
    part.span = {tree.parts[part.operands.front()].span.begin,
                 tree.parts[part.operands.back()].span.end};
    open.resize(first);
    Push(std::move(part));
    return tree.parts.back();
  }
  void Deepen(std::uint32_t at) {
    if (++depth <= kMaxFormulaDepth) return;
    throw FormulaError{
        {Code::kLimit,
         {at, at + 1},
         fmt::format("a formula nests at most {} deep", kMaxFormulaDepth)}};
  }
};

// What is missing where a rule must match and does not.
template <typename Rule>
inline constexpr std::string_view kMissing =
    "a number, a quantity, a function or '('";
template <>
inline constexpr std::string_view kMissing<rules::fraction_digits> =
    "digits after '.'";
template <>
inline constexpr std::string_view kMissing<rules::exponent_digits> =
    "the digits of an exponent";
template <>
inline constexpr std::string_view kMissing<rules::number_end> =
    "an operator after the number";
template <>
inline constexpr std::string_view kMissing<rules::close> = "an operator or ')'";
template <>
inline constexpr std::string_view kMissing<rules::call_close> =
    "an operator, ',' or ')'";
template <>
inline constexpr std::string_view kMissing<rules::colon> =
    "an operator, or ':' and what else it is";
template <>
inline constexpr std::string_view kMissing<rules::end> =
    "an operator or the end of the formula";

struct Habit {
  std::string_view found;
  std::string_view help;
};
// Of other languages; the longer before those that they begin with.
constexpr Habit kHabits[] = {
    {"&", "write 'and'"},
    {"|", "write 'or'"},
    {"*", "there is no power: multiply, or write exp(y * log(x))"},
    {"^", "there is no power: multiply, or write exp(y * log(x))"},
    {"<>", "write '!='"},
    {"!", "write 'not'"},
    {"=", "write '=='"},
    {"<", "compare two at a time: 'a < b and b < c'"},
    {">", "compare two at a time: 'a < b and b < c'"},
    {"%", "there is no percentage and no remainder: divide by 100"},
    {".", "a number has a digit before its point: '0.5'"},
    {"+", "a number has no '+' before it"},
    {"if", "write 'condition ? one : other'"},
    {"else", "write 'condition ? one : other'"},
};

std::string_view HelpFor(std::string_view rest) {
  for (const Habit& habit : kHabits)
    if (rest.starts_with(habit.found)) return habit.help;
  return "";
}

Diagnostic Missing(std::string_view expected, std::string_view text,
                   std::uint32_t at) {
  const Found found = FoundAt(text, at);
  Diagnostic problem(Code::kFormulaSyntax, found.span,
                     fmt::format("expected {}, found {}", expected,
                                 found.is_end ? "the end" : found.quoted));
  return problem.WithHelp(std::string(HelpFor(text.substr(at))));
}

template <typename Rule>
struct FormulaControl : tao::pegtl::normal<Rule> {
  template <typename Input>
  [[noreturn]] static void raise(const Input& in, FormulaBuilder& b) {
    throw FormulaError{
        Missing(kMissing<Rule>, b.tree.text,
                static_cast<std::uint32_t>(in.current() - b.tree.text.data()))};
  }
};

template <typename Rule>
struct FormulaAction : tao::pegtl::nothing<Rule> {};

template <>
struct FormulaAction<rules::number> {
  template <typename Input>
  static void apply(const Input& in, FormulaBuilder& b) {
    FormulaPart part;
    part.span = b.SpanOf(in);
    const auto number = ParseNumber<double>(b.tree.Text(part.span));
    if (!number)
      throw FormulaError{
          {Code::kBeyondDouble, part.span,
           fmt::format("no double can hold {}", b.tree.Text(part.span))}};
    part.number = *number;
    b.Push(std::move(part));
  }
};

template <int kValue>
struct TakeTruth {
  template <typename Input>
  static void apply(const Input& in, FormulaBuilder& b) {
    FormulaPart part;
    part.kind = PartKind::kTruth;
    part.span = b.SpanOf(in);
    part.number = kValue;
    b.Push(std::move(part));
  }
};

template <>
struct FormulaAction<rules::true_word> : TakeTruth<1> {};
template <>
struct FormulaAction<rules::false_word> : TakeTruth<0> {};

template <>
struct FormulaAction<rules::name> {
  template <typename Input>
  static void apply(const Input& in, FormulaBuilder& b) {
    b.name = b.SpanOf(in);
  }
};

template <>
struct FormulaAction<rules::variable> {
  static void apply0(FormulaBuilder& b) {
    FormulaPart part;
    part.kind = PartKind::kName;
    part.span = part.name = b.name;
    b.Push(std::move(part));
  }
};

template <>
struct FormulaAction<rules::call_open> {
  template <typename Input>
  static void apply(const Input& in, FormulaBuilder& b) {
    b.Deepen(b.SpanOf(in).begin);
    b.calls.push_back({b.name, b.open.size()});
  }
};

template <>
struct FormulaAction<rules::call_end> {
  template <typename Input>
  static void apply(const Input& in, FormulaBuilder& b) {
    const OpenCall call = b.calls.back();
    b.calls.pop_back();
    FormulaPart& part = b.Join(PartKind::kCall, call.first);
    part.name = call.name;
    part.span = {call.name.begin, b.SpanOf(in).end};
    --b.depth;
  }
};

struct Open {
  template <typename Input>
  static void apply(const Input& in, FormulaBuilder& b) {
    b.Deepen(b.SpanOf(in).begin);
  }
};
template <>
struct FormulaAction<rules::open> : Open {};
template <>
struct FormulaAction<rules::question> : Open {};
template <>
struct FormulaAction<rules::close> {
  static void apply0(FormulaBuilder& b) { --b.depth; }
};

struct OpenSign {
  template <typename Input>
  static void apply(const Input& in, FormulaBuilder& b) {
    b.signs.push_back(b.SpanOf(in).begin);
    b.Deepen(b.signs.back());
  }
};
template <>
struct FormulaAction<rules::minus> : OpenSign {};
template <>
struct FormulaAction<rules::not_mark> : OpenSign {};

template <PartKind kKind>
struct JoinSign {
  static void apply0(FormulaBuilder& b) {
    b.Join(kKind, b.open.size() - 1).span.begin = b.signs.back();
    b.signs.pop_back();
    --b.depth;
  }
};
template <>
struct FormulaAction<rules::negated> : JoinSign<PartKind::kNegate> {};
template <>
struct FormulaAction<rules::denied> : JoinSign<PartKind::kNot> {};

template <PartKind kKind>
struct JoinTwo {
  static void apply0(FormulaBuilder& b) { b.Join(kKind, b.open.size() - 2); }
};
template <>
struct FormulaAction<rules::multiply_step> : JoinTwo<PartKind::kMultiply> {};
template <>
struct FormulaAction<rules::divide_step> : JoinTwo<PartKind::kDivide> {};
template <>
struct FormulaAction<rules::add_step> : JoinTwo<PartKind::kAdd> {};
template <>
struct FormulaAction<rules::subtract_step> : JoinTwo<PartKind::kSubtract> {};
template <>
struct FormulaAction<rules::less_equal_step> : JoinTwo<PartKind::kLessEqual> {};
template <>
struct FormulaAction<rules::greater_equal_step>
    : JoinTwo<PartKind::kGreaterEqual> {};
template <>
struct FormulaAction<rules::less_step> : JoinTwo<PartKind::kLess> {};
template <>
struct FormulaAction<rules::greater_step> : JoinTwo<PartKind::kGreater> {};
template <>
struct FormulaAction<rules::equal_step> : JoinTwo<PartKind::kEqual> {};
template <>
struct FormulaAction<rules::not_equal_step> : JoinTwo<PartKind::kNotEqual> {};
template <>
struct FormulaAction<rules::and_step> : JoinTwo<PartKind::kAnd> {};
template <>
struct FormulaAction<rules::or_step> : JoinTwo<PartKind::kOr> {};

template <>
struct FormulaAction<rules::choice_step> {
  static void apply0(FormulaBuilder& b) {
    b.Join(PartKind::kChoice, b.open.size() - 3);
    --b.depth;
  }
};

}  // namespace

Result<FormulaTree> ParseFormula(std::string_view text) {
  if (text.size() > kMaxFormulaLength)
    return Diagnostic(Code::kLimit, {},
                      fmt::format("a formula has at most {} characters, found "
                                  "{}",
                                  kMaxFormulaLength, text.size()));
  FormulaBuilder b;
  b.tree.text = text;
  using Input = tao::pegtl::memory_input<tao::pegtl::tracking_mode::lazy>;
  const char* const begin = b.tree.text.data();
  Input in(begin, begin + b.tree.text.size(), "");
  try {
    [[maybe_unused]] const bool matched =
        tao::pegtl::parse<rules::whole, FormulaAction, FormulaControl>(in, b);
    assert(matched && b.open.size() == 1);
  } catch (const FormulaError& error) {
    return error.diagnostic;
  }
  return std::move(b.tree);
}

}  // namespace plsc
