#pragma once

// What a match builds: parts of the item at hand, and at its end the item.
// See builder.h.

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

// Items of the header.

template <>
struct Action<genotype_item> {
  static void apply0(Builder& b) {
    b.EndItem(ast::ItemKind::kGenotype, b.file.genotypes.size());
    b.file.genotypes.push_back({b.name});
  }
};

template <>
struct Action<axiom_item> {
  static void apply0(Builder& b) {
    b.EndItem(ast::ItemKind::kAxiom, b.file.axioms.size());
    b.file.axioms.push_back({b.name});
  }
};

template <>
struct Action<let_item> {
  static void apply0(Builder& b) {
    b.EndItem(ast::ItemKind::kLet, b.file.lets.size());
    b.file.lets.push_back({b.name, b.value});
  }
};

template <>
struct Action<setting_key> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    const Span span = SpanOf(in, b);
    b.BeginItem(span);
    const std::string_view word = b.file.Text(span);
    using enum ast::SettingKey;
    b.setting_key = word == "iterations"    ? kIterations
                    : word == "max_modules" ? kMaxModules
                    : word == "move_to_new" ? kMoveToNew
                    : word == "max_terms"   ? kMaxTerms
                                            : kMaxRules;
  }
};

template <>
struct Action<setting_item> {
  static void apply0(Builder& b) {
    b.EndItem(ast::ItemKind::kSetting, b.file.settings.size());
    b.file.settings.push_back({b.setting_key, b.value});
  }
};

// Types.

template <>
struct Action<low_bound> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.TakeNumber(SpanOf(in, b));
    b.bounds.low = b.value;
  }
};

template <>
struct Action<high_bound> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.TakeNumber(SpanOf(in, b));
    b.bounds.high = b.value;
    b.bounds.is_present = true;
  }
};

template <>
struct Action<real_type> {
  static void apply0(Builder& b) { b.sense.type = ast::SenseType::kReal; }
};

template <>
struct Action<enum_type> {
  static void apply0(Builder& b) { b.sense.type = ast::SenseType::kEnum; }
};

template <>
struct Action<enum_value> {
  template <typename Input>
  static bool apply(const Input& in, Builder& b) {
    const Span span = SpanOf(in, b);
    if (IsKeyword(b.file.Text(span))) return false;
    b.file.names.push_back(span);
    ++b.sense.values.count;
    return true;
  }
};

template <>
struct Action<sense_item> {
  static void apply0(Builder& b) {
    b.sense.name = b.name;
    b.sense.bounds = b.bounds;
    b.EndItem(ast::ItemKind::kSense, b.file.senses.size());
    b.file.senses.push_back(b.sense);
  }
};

// A file's own alphabet.

// clang-format off
template <> struct Action<vocabulary_version> : TakeNumber {};
// clang-format on

template <bool kReplaceable>
struct BeginGroup {
  static void apply0(Builder& b) { b.is_replaceable = kReplaceable; }
};

// clang-format off
template <> struct Action<replaceable_word> : BeginGroup<true> {};
template <> struct Action<terminal_word>    : BeginGroup<false> {};
// clang-format on

template <>
struct Action<declared_name> {
  template <typename Input>
  static bool apply(const Input& in, Builder& b) {
    const Span span = SpanOf(in, b);
    if (IsKeyword(b.file.Text(span))) return false;
    const auto first = static_cast<std::uint32_t>(b.file.parameters.size());
    b.file.declarations.push_back({span, span, b.is_replaceable, {first, 0}});
    ++b.alphabet.declarations.count;
    return true;
  }
};

template <>
struct Action<parameter_name> {
  template <typename Input>
  static bool apply(const Input& in, Builder& b) {
    const Span span = SpanOf(in, b);
    if (IsKeyword(b.file.Text(span))) return false;
    b.bounds = {};
    b.file.parameters.push_back({span, false, {}});
    ++b.file.declarations.back().parameters.count;
    return true;
  }
};

template <>
struct Action<int_word> {
  static void apply0(Builder& b) { b.file.parameters.back().is_integer = true; }
};

template <>
struct Action<parameter> {
  static void apply0(Builder& b) { b.file.parameters.back().bounds = b.bounds; }
};

template <>
struct Action<declaration> {
  static void apply0(Builder& b) {
    b.file.declarations.back().span.end = b.previous_end;
  }
};

template <>
struct Action<alphabet_open> {
  static void apply0(Builder& b) { b.alphabet.is_own = true; }
};

template <>
struct Action<alphabet_item> {
  static void apply0(Builder& b) {
    b.alphabet.name = b.name;
    b.alphabet.version = b.value;
    b.alphabet.open = b.open;
    b.alphabet.close = b.close;
    b.EndItem(ast::ItemKind::kAlphabet, b.file.alphabets.size());
    b.file.alphabets.push_back(b.alphabet);
  }
};

// Environments.

template <>
struct Action<entry_state> {
  template <typename Input>
  static bool apply(const Input& in, Builder& b) {
    b.entry.state = SpanOf(in, b);
    return !IsKeyword(b.file.Text(b.entry.state));
  }
};

template <>
struct Action<entry_value> {
  static void apply0(Builder& b) {
    b.CheckTermValue();
    b.entry.value = b.value;
    b.entry.span = {b.entry.state.begin, b.value.span.end};
    b.file.entries.push_back(b.entry);
    ++b.environment.entries.count;
  }
};

template <>
struct Action<environment_item> {
  static void apply0(Builder& b) {
    b.environment.name = b.name;
    b.environment.open = b.open;
    b.environment.close = b.close;
    b.EndItem(ast::ItemKind::kEnvironment, b.file.environments.size());
    b.file.environments.push_back(b.environment);
  }
};

// The version line.

template <>
struct Action<version_number> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.TakeNumber(SpanOf(in, b));
  }
};

template <>
struct Action<version> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.file.version = {SpanOf(in, b).begin, b.previous_end};
    b.file.version_number = b.value;
  }
};

}  // namespace plsc::grammar
