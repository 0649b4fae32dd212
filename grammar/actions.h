#pragma once

// What a match builds: parts of the item at hand, and at its end the item.
// See builder.h.

#include "grammar/builder.h"
#include "grammar/keywords.h"
#include "grammar/rules.h"

namespace plsc::grammar {

template <typename Rule>
struct action : nothing<Rule> {};

template <typename Input>
Span SpanOf(const Input& in, const Builder& b) {
  return {static_cast<std::uint32_t>(in.begin() - b.base),
          static_cast<std::uint32_t>(in.end() - b.base)};
}

// Bases of actions, by what they do with what matched.

struct take_number {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.TakeNumber(SpanOf(in, b));
  }
};

template <ast::Value::Kind kKind>
struct take_value {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.value = {};
    b.value.span = SpanOf(in, b);
    b.value.kind = kKind;
  }
};

template <Span Builder::*kMember>
struct take_span {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.*kMember = SpanOf(in, b);
  }
};

// A name is an identifier that is no keyword; else the rule does not match.
template <Span Builder::*kMember>
struct take_name {
  template <typename Input>
  static bool apply(const Input& in, Builder& b) {
    b.*kMember = SpanOf(in, b);
    return !IsKeyword(b.file.Text(b.*kMember));
  }
};

template <ast::Comparison kComparison>
struct take_comparison {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.term.comparison = kComparison;
    b.term.comparison_span = SpanOf(in, b);
  }
};

template <ast::Connective kConnective>
struct take_connective {
  static void apply0(Builder& b) { b.connective = kConnective; }
};

// Tokens.

template <>
struct action<comment> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    Span span = SpanOf(in, b);
    while (span.end > span.begin && b.base[span.end - 1] == '\r') --span.end;
    b.file.comments.push_back(span);
  }
};

template <>
struct action<gap> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.previous_end = SpanOf(in, b).begin;
  }
};

// clang-format off
template <> struct action<number>      : take_number {};
template <> struct action<true_value>  : take_value<ast::Value::Kind::kTrue> {};
template <> struct action<false_value> : take_value<ast::Value::Kind::kFalse> {};
template <> struct action<open_mark>   : take_span<&Builder::open> {};
template <> struct action<end_mark>    : take_span<&Builder::close> {};
template <> struct action<item_name>   : take_name<&Builder::name> {};
template <> struct action<head>        : take_name<&Builder::name> {};

template <> struct action<equal>         : take_comparison<ast::Comparison::kEqual> {};
template <> struct action<not_equal>     : take_comparison<ast::Comparison::kNotEqual> {};
template <> struct action<less>          : take_comparison<ast::Comparison::kLess> {};
template <> struct action<less_equal>    : take_comparison<ast::Comparison::kLessEqual> {};
template <> struct action<greater>       : take_comparison<ast::Comparison::kGreater> {};
template <> struct action<greater_equal> : take_comparison<ast::Comparison::kGreaterEqual> {};
template <> struct action<and_word>      : take_connective<ast::Connective::kAnd> {};
template <> struct action<or_word>       : take_connective<ast::Connective::kOr> {};
// clang-format on

template <>
struct action<name_value> {
  template <typename Input>
  static bool apply(const Input& in, Builder& b) {
    take_value<ast::Value::Kind::kName>::apply(in, b);
    return !IsKeyword(b.file.Text(b.value.span));
  }
};

template <typename Keyword>
struct action<begin_item<Keyword>> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.BeginItem({SpanOf(in, b).begin, b.previous_end});
  }
};

// Rules.

template <>
struct action<symbol_name> {
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
struct action<argument_value> {
  static void apply0(Builder& b) {
    b.file.arguments.push_back(b.value);
    ++b.file.symbols.back().arguments.count;
  }
};

template <>
struct action<close_mark> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.file.symbols.back().has_parens = true;
    b.file.symbols.back().span.end = SpanOf(in, b).end;
  }
};

template <>
struct action<state_name> {
  template <typename Input>
  static bool apply(const Input& in, Builder& b) {
    b.term.state = SpanOf(in, b);
    return !IsKeyword(b.file.Text(b.term.state));
  }
};

template <>
struct action<term_value> {
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
struct action<rule_item> {
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
struct action<genotype_item> {
  static void apply0(Builder& b) {
    b.EndItem(ast::ItemKind::kGenotype, b.file.genotypes.size());
    b.file.genotypes.push_back({b.name});
  }
};

template <>
struct action<axiom_item> {
  static void apply0(Builder& b) {
    b.EndItem(ast::ItemKind::kAxiom, b.file.axioms.size());
    b.file.axioms.push_back({b.name});
  }
};

template <>
struct action<let_item> {
  static void apply0(Builder& b) {
    b.EndItem(ast::ItemKind::kLet, b.file.lets.size());
    b.file.lets.push_back({b.name, b.value});
  }
};

template <>
struct action<setting_key> {
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
struct action<setting_item> {
  static void apply0(Builder& b) {
    b.EndItem(ast::ItemKind::kSetting, b.file.settings.size());
    b.file.settings.push_back({b.setting_key, b.value});
  }
};

// Types.

template <>
struct action<low_bound> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.TakeNumber(SpanOf(in, b));
    b.bounds.low = b.value;
  }
};

template <>
struct action<high_bound> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.TakeNumber(SpanOf(in, b));
    b.bounds.high = b.value;
    b.bounds.is_present = true;
  }
};

template <>
struct action<real_type> {
  static void apply0(Builder& b) { b.sense.type = ast::SenseType::kReal; }
};

template <>
struct action<enum_type> {
  static void apply0(Builder& b) { b.sense.type = ast::SenseType::kEnum; }
};

template <>
struct action<enum_value> {
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
struct action<sense_item> {
  static void apply0(Builder& b) {
    b.sense.name = b.name;
    b.sense.bounds = b.bounds;
    b.EndItem(ast::ItemKind::kSense, b.file.senses.size());
    b.file.senses.push_back(b.sense);
  }
};

// A file's own alphabet.

// clang-format off
template <> struct action<vocabulary_version> : take_number {};
// clang-format on

template <bool kReplaceable>
struct begin_group {
  static void apply0(Builder& b) { b.is_replaceable = kReplaceable; }
};

// clang-format off
template <> struct action<replaceable_word> : begin_group<true> {};
template <> struct action<terminal_word>    : begin_group<false> {};
// clang-format on

template <>
struct action<declared_name> {
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
struct action<parameter_name> {
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
struct action<int_word> {
  static void apply0(Builder& b) { b.file.parameters.back().is_integer = true; }
};

template <>
struct action<parameter> {
  static void apply0(Builder& b) { b.file.parameters.back().bounds = b.bounds; }
};

template <>
struct action<declaration> {
  static void apply0(Builder& b) {
    b.file.declarations.back().span.end = b.previous_end;
  }
};

template <>
struct action<alphabet_open> {
  static void apply0(Builder& b) { b.alphabet.is_own = true; }
};

template <>
struct action<alphabet_item> {
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
struct action<entry_state> {
  template <typename Input>
  static bool apply(const Input& in, Builder& b) {
    b.entry.state = SpanOf(in, b);
    return !IsKeyword(b.file.Text(b.entry.state));
  }
};

template <>
struct action<entry_value> {
  static void apply0(Builder& b) {
    b.CheckTermValue();
    b.entry.value = b.value;
    b.entry.span = {b.entry.state.begin, b.value.span.end};
    b.file.entries.push_back(b.entry);
    ++b.environment.entries.count;
  }
};

template <>
struct action<environment_item> {
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
struct action<version_number> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.TakeNumber(SpanOf(in, b));
  }
};

template <>
struct action<version> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.file.version = {SpanOf(in, b).begin, b.previous_end};
    b.file.version_number = b.value;
  }
};

}  // namespace plsc::grammar
