#pragma once

// What a match builds: parts of the item at hand, and at its end the item.
// Here the bases of all actions and those of rules; header_actions.h has the
// rest. The parts are those of builder.h.

#include "grammar/builder.h"
#include "grammar/keywords.h"
#include "grammar/rules.h"

namespace plsc::grammar {

template <typename Rule>
struct Action : nothing<Rule> {};

template <typename Input>
Span SpanOf(const Input& in, const Builder& b) {
  return {static_cast<std::uint32_t>(in.begin() - b.base),
          static_cast<std::uint32_t>(in.end() - b.base)};
}

// Bases of actions, by what they do with what matched.

struct TakeNumber {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.TakeNumber(SpanOf(in, b));
  }
};

template <ast::Value::Kind kKind>
struct TakeValue {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.value = {};
    b.value.span = SpanOf(in, b);
    b.value.kind = kKind;
  }
};

template <Span Builder::*kMember>
struct TakeSpan {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.*kMember = SpanOf(in, b);
  }
};

// A name is an identifier that is no keyword; else the rule does not match.
template <Span Builder::*kMember>
struct TakeName {
  template <typename Input>
  static bool apply(const Input& in, Builder& b) {
    b.*kMember = SpanOf(in, b);
    return !IsKeyword(b.file.Text(b.*kMember));
  }
};

template <ast::Comparison kComparison>
struct TakeComparison {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.term.comparison = kComparison;
    b.term.comparison_span = SpanOf(in, b);
  }
};

template <ast::Connective kConnective>
struct TakeConnective {
  static void apply0(Builder& b) { b.connective = kConnective; }
};

// Tokens.

template <>
struct Action<comment> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    Span span = SpanOf(in, b);
    while (span.end > span.begin && b.base[span.end - 1] == '\r') --span.end;
    b.file.comments.push_back(span);
  }
};

template <>
struct Action<gap> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.previous_end = SpanOf(in, b).begin;
  }
};

// clang-format off
template <> struct Action<number>      : TakeNumber {};
template <> struct Action<true_value>  : TakeValue<ast::Value::Kind::kTrue> {};
template <> struct Action<false_value> : TakeValue<ast::Value::Kind::kFalse> {};
template <> struct Action<open_mark>   : TakeSpan<&Builder::open> {};
template <> struct Action<end_mark>    : TakeSpan<&Builder::close> {};
template <> struct Action<item_name>   : TakeName<&Builder::name> {};
template <> struct Action<head>        : TakeName<&Builder::name> {};

template <> struct Action<equal>         : TakeComparison<ast::Comparison::kEqual> {};
template <> struct Action<not_equal>     : TakeComparison<ast::Comparison::kNotEqual> {};
template <> struct Action<less>          : TakeComparison<ast::Comparison::kLess> {};
template <> struct Action<less_equal>    : TakeComparison<ast::Comparison::kLessEqual> {};
template <> struct Action<greater>       : TakeComparison<ast::Comparison::kGreater> {};
template <> struct Action<greater_equal> : TakeComparison<ast::Comparison::kGreaterEqual> {};
template <> struct Action<and_word>      : TakeConnective<ast::Connective::kAnd> {};
template <> struct Action<or_word>       : TakeConnective<ast::Connective::kOr> {};
// clang-format on

// No item refers to a genotype by its name, so only a word that begins an item
// would be mistaken for one. `genotype test` is fine all the same: people call
// their first genotype so.
template <>
struct Action<genotype_name> {
  template <typename Input>
  static bool apply(const Input& in, Builder& b) {
    b.name = SpanOf(in, b);
    return IsGenotypeName(b.file.Text(b.name));
  }
};

template <>
struct Action<name_value> {
  template <typename Input>
  static bool apply(const Input& in, Builder& b) {
    TakeValue<ast::Value::Kind::kName>::apply(in, b);
    return !IsKeyword(b.file.Text(b.value.span));
  }
};

template <typename Keyword>
struct Action<begin_item<Keyword>> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.BeginItem({SpanOf(in, b).begin, b.previous_end});
  }
};

// Rules.

template <>
struct Action<symbol_name> {
  template <typename Input>
  static bool apply(const Input& in, Builder& b) {
    const Span span = SpanOf(in, b);
    if (IsKeyword(b.file.Text(span))) return false;
    const auto first = static_cast<std::uint32_t>(b.file.arguments.size());
    b.file.symbols.push_back({span, span, {first, 0}, false});
    ++b.rule.symbols.count;
    return true;
  }
};

template <>
struct Action<argument_value> {
  static void apply0(Builder& b) {
    b.file.arguments.push_back(b.value);
    ++b.file.symbols.back().arguments.count;
  }
};

template <>
struct Action<close_mark> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.file.symbols.back().has_parens = true;
    b.file.symbols.back().span.end = SpanOf(in, b).end;
  }
};

template <>
struct Action<state_name> {
  template <typename Input>
  static bool apply(const Input& in, Builder& b) {
    b.term.state = SpanOf(in, b);
    return !IsKeyword(b.file.Text(b.term.state));
  }
};

template <>
struct Action<term_value> {
  static void apply0(Builder& b) {
    b.CheckTermValue();
    b.term.value = b.value;
    b.term.span = {b.term.state.begin, b.value.span.end};
    b.term.connective = b.connective;
    if (b.rule.terms.count == 0) b.rule.clause.begin = b.term.span.begin;
    b.rule.clause.end = b.term.span.end;
    b.file.terms.push_back(b.term);
    ++b.rule.terms.count;
  }
};

template <>
struct Action<rule_item> {
  static void apply0(Builder& b) {
    b.rule.head = b.name;
    b.rule.open = b.open;
    b.rule.close = b.close;
    b.EndItem(ast::ItemKind::kRule, b.file.rules.size());
    b.file.rules.push_back(b.rule);
  }
};

}  // namespace plsc::grammar
