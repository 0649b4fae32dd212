#pragma once

// From PEGTL's rule types to EBNF: every rule names its own kind (rule_t) and
// its parts (subs_t), so that this needs to know the kinds, not the rules.
//
// Left out, as the docs say once: gaps between tokens, and conditions on what
// follows (at<>, not_at<>). Of `sor<try_catch<...>, ...>` only the first
// alternative is shown, because the others only go on after an error. What a
// must<> requires is simply what stands there.

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <tao/pegtl.hpp>
#include <type_traits>
#include <vector>

#include "grammar/ebnf.h"
#include "grammar/rules.h"

namespace plsc::testing {

namespace pegtl_internal = tao::pegtl::internal;

/// A rule whose match() is written by hand says here which rule it reads like:
/// `template <> struct ReadsLike<grammar::x> { using type = ...; };`.
template <typename Rule>
struct ReadsLike {
  using type = Rule;
};

/// What PEGTL's own template makes of the rule.
template <typename Rule>
using BodyOf = typename ReadsLike<Rule>::type::rule_t;

/// Not shown, with all that it is made of.
template <typename Rule>
inline constexpr bool kIsHidden = false;
template <>
inline constexpr bool kIsHidden<grammar::gap> = true;

/// Rules of the library that a reader knows by a name.
template <typename Rule>
inline constexpr const char* kLibraryName = nullptr;
template <>
inline constexpr const char* kLibraryName<tao::pegtl::digit> = "digit";
template <>
inline constexpr const char* kLibraryName<tao::pegtl::identifier> = "name";

template <typename Rule>
inline constexpr bool kIsTryCatch = false;
template <typename Exception, typename... Rules>
inline constexpr bool
    kIsTryCatch<pegtl_internal::try_catch_type<Exception, Rules...>> = true;
// As PEGTL wraps it.
template <typename Rule>
inline constexpr bool kIsTryCatch<pegtl_internal::seq<Rule>> =
    kIsTryCatch<typename Rule::rule_t>;

inline Ebnf Terminal(std::string text) {
  return {Ebnf::Kind::kTerminal, std::move(text), {}};
}

inline Ebnf Quoted(std::string_view text) {
  const bool has_quote = text.find('"') != std::string_view::npos;
  return Terminal(fmt::format("{0}{1}{0}", has_quote ? '\'' : '"', text));
}

template <typename Peek>
Ebnf Character(typename Peek::data_t c) {
  const auto code = static_cast<std::uint32_t>(
      static_cast<std::make_unsigned_t<typename Peek::data_t>>(c));
  if (code > ' ' && code < 0x7F)
    return Quoted(std::string(1, static_cast<char>(code)));
  return Terminal(fmt::format("? U+{:04X} ?", code));
}

template <typename Peek>
Ebnf CharacterRange(typename Peek::data_t low, typename Peek::data_t high) {
  return Terminal(fmt::format("{} ... {}", Character<Peek>(low).text,
                              Character<Peek>(high).text));
}

class EbnfWalk {
 public:
  explicit EbnfWalk(EbnfGrammar& grammar) : grammar_(grammar) {}

  /// The key of a rule that has a line of its own; adds it on the first visit.
  template <typename Rule>
  std::string Add(std::string_view name) {
    // Rules that are the same type underneath differ only in their actions.
    using Body = BodyOf<Rule>;
    std::string key(tao::pegtl::demangle<Body>());
    const bool is_new = grammar_.rules.count(key) == 0;
    EbnfRule& rule = grammar_.rules[key];
    rule.names.emplace_back(name);
    if (is_new) {
      Ebnf body = OfType(static_cast<Body*>(nullptr));
      grammar_.rules[key].body = std::move(body);
    }
    return key;
  }

  template <typename Rule>
  Ebnf Of() {
    if constexpr (kIsHidden<Rule>) {
      return {};
    } else if constexpr (kLibraryName<Rule> != nullptr) {
      return {Ebnf::Kind::kRule, Add<Rule>(kLibraryName<Rule>), {}};
    } else {
      // Templates (token<>, mark<>) are ways to write rules, no rules.
      constexpr std::string_view kNamespace = "plsc::grammar::";
      const std::string_view type = tao::pegtl::demangle<Rule>();
      if (type.starts_with(kNamespace) &&
          type.find('<') == std::string_view::npos)
        return {
            Ebnf::Kind::kRule, Add<Rule>(type.substr(kNamespace.size())), {}};
      return OfType(static_cast<BodyOf<Rule>*>(nullptr));
    }
  }

 private:
  template <typename... Rules>
  Ebnf List(Ebnf::Kind kind) {
    return {kind, "", std::vector<Ebnf>{Of<Rules>()...}};
  }

  template <typename Rule>
  Ebnf OfType(Rule*) {
    static_assert(sizeof(Rule) == 0,
                  "EBNF does not know this kind of rule: add an overload of "
                  "OfType here, or for a rule with a match() of its own say "
                  "with ReadsLike which rule it reads like");
    return {};
  }
  // clang-format off
  Ebnf OfType(pegtl_internal::success*) { return {}; }
  Ebnf OfType(pegtl_internal::eof*) { return {}; }
  template <typename... R> Ebnf OfType(pegtl_internal::at<R...>*) { return {}; }
  template <typename... R> Ebnf OfType(pegtl_internal::not_at<R...>*) { return {}; }
  template <typename... R> Ebnf OfType(pegtl_internal::seq<R...>*) { return List<R...>(Ebnf::Kind::kSequence); }
  template <typename... R> Ebnf OfType(pegtl_internal::must<R...>*) { return List<R...>(Ebnf::Kind::kSequence); }
  template <typename C, typename... R> Ebnf OfType(pegtl_internal::if_must<false, C, R...>*) { return List<C, R...>(Ebnf::Kind::kSequence); }
  template <typename E, typename... R> Ebnf OfType(pegtl_internal::try_catch_type<E, R...>*) { return List<R...>(Ebnf::Kind::kSequence); }
  template <typename... R> Ebnf OfType(pegtl_internal::sor<R...>*) { return OfChoice<R...>(); }
  template <typename... R> Ebnf OfType(pegtl_internal::star<R...>*) { return {Ebnf::Kind::kRepeat, "", {List<R...>(Ebnf::Kind::kSequence)}}; }
  template <typename... R> Ebnf OfType(pegtl_internal::opt<R...>*) { return {Ebnf::Kind::kOptional, "", {List<R...>(Ebnf::Kind::kSequence)}}; }
  template <typename C, typename... R> Ebnf OfType(pegtl_internal::if_must<true, C, R...>*) { return {Ebnf::Kind::kOptional, "", {List<C, R...>(Ebnf::Kind::kSequence)}}; }
  // clang-format on

  template <typename... R>
  Ebnf OfType(pegtl_internal::plus<R...>*) {
    const Ebnf once = List<R...>(Ebnf::Kind::kSequence);
    return {
        Ebnf::Kind::kSequence, "", {once, {Ebnf::Kind::kRepeat, "", {once}}}};
  }

  template <typename Condition, typename... R>
  Ebnf OfType(pegtl_internal::until<Condition, R...>*) {
    Ebnf inner = List<R...>(Ebnf::Kind::kSequence);
    if constexpr (sizeof...(R) == 0) inner = Terminal("? any character ?");
    return {Ebnf::Kind::kSequence,
            "",
            {{Ebnf::Kind::kRepeat, "", {inner}}, Of<Condition>()}};
  }

  template <char... C>
  Ebnf OfType(pegtl_internal::string<C...>*) {
    static constexpr char kText[] = {C...};
    return Quoted({kText, sizeof...(C)});
  }

  template <pegtl_internal::result_on_found kFound, typename Peek,
            typename Peek::data_t... C>
  Ebnf OfType(pegtl_internal::one<kFound, Peek, C...>*) {
    Ebnf choice{Ebnf::Kind::kChoice, "", {Character<Peek>(C)...}};
    if (kFound == pegtl_internal::result_on_found::success) return choice;
    std::vector<std::string> others;
    for (const Ebnf& part : choice.parts)
      others.push_back(part.text.starts_with('?')
                           ? part.text.substr(2, part.text.size() - 4)
                           : part.text);
    return Terminal(
        fmt::format("? any character but {} ?", fmt::join(others, ", ")));
  }

  template <typename Peek, typename Peek::data_t kLow,
            typename Peek::data_t kHigh>
  Ebnf OfType(pegtl_internal::range<pegtl_internal::result_on_found::success,
                                    Peek, kLow, kHigh>*) {
    return CharacterRange<Peek>(kLow, kHigh);
  }

  // Pairs of ends, and with an odd number a single character behind them.
  template <typename Peek, typename Peek::data_t... C>
  Ebnf OfType(pegtl_internal::ranges<Peek, C...>*) {
    const std::vector<typename Peek::data_t> ends{C...};
    Ebnf choice{Ebnf::Kind::kChoice, "", {}};
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
      choice.parts.push_back(CharacterRange<Peek>(ends[i], ends[i + 1]));
    if (ends.size() % 2 == 1)
      choice.parts.push_back(Character<Peek>(ends.back()));
    return choice;
  }

  template <typename First, typename... Others>
  Ebnf OfChoice() {
    if constexpr (kIsTryCatch<typename First::rule_t>)
      return Of<First>();
    else
      return List<First, Others...>(Ebnf::Kind::kChoice);
  }

  EbnfGrammar& grammar_;
};

}  // namespace plsc::testing
