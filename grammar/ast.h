#pragma once

// A genotype file as it was written: items in file order, every part with its
// bytes, nothing resolved. Texts are spans of the source, which must outlive
// the tree. Lists of parts live in pools of the File and are referred to by
// Range, because a hundred thousand genotypes a night are parsed and one
// allocation a list would be most of the work.

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "grammar/source.h"

namespace plsc::ast {

/// Elements [first, first + count) of one of the File's pools.
struct Range {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

/// What stands for a value: `True`, `-1.5`, `wet`, or the name of a constant.
struct Value {
  enum class Kind : std::uint8_t { kTrue, kFalse, kNumber, kName };
  Span span;
  Kind kind = Kind::kNumber;
  bool is_integer = false;  ///< kNumber: written without '.' and exponent
  double number = 0;        ///< kNumber only
};

/// `LOW..HIGH`, both numbers.
struct Bounds {
  bool is_present = false;
  Value low;
  Value high;
};

struct Symbol {
  Span span;  ///< with the arguments
  Span name;
  Range arguments;  ///< of File::arguments
  bool has_parens = false;
};

enum class Comparison : std::uint8_t {
  kEqual,
  kNotEqual,
  kLess,
  kLessEqual,
  kGreater,
  kGreaterEqual,
};

enum class Connective : std::uint8_t { kNone, kAnd, kOr };

struct Term {
  Span span;
  Connective connective = Connective::kNone;  ///< with the term before it
  Span state;
  Span comparison_span;
  Comparison comparison = Comparison::kEqual;
  Value value;
};

struct Rule {
  Span head;
  Span clause;  ///< first to last term; empty when there is no clause
  Range terms;  ///< of File::terms
  Span open;    ///< '{'
  Span close;   ///< '}'
  Range symbols;
};

/// `genotype NAME` and `axiom NAME`.
struct Naming {
  Span name;
};

struct Parameter {
  Span name;
  bool is_integer = false;
  Bounds bounds;
};

struct Declaration {
  Span span;
  Span name;
  bool is_replaceable = false;
  Range parameters;  ///< of File::parameters
};

/// `alphabet plasticoding 1` or `alphabet NAME { ... }`.
struct Alphabet {
  Span name;
  bool is_own = false;  ///< has a body
  Value version;        ///< when it has none
  Span open;
  Span close;
  Range declarations;  ///< of File::declarations
};

enum class SenseType : std::uint8_t { kBool, kReal, kEnum };

struct Sense {
  Span name;
  SenseType type = SenseType::kBool;
  Bounds bounds;  ///< kReal
  Range values;   ///< kEnum, of File::names
};

struct Let {
  Span name;
  Value value;
};

/// Also the order in which settings are printed.
enum class SettingKey : std::uint8_t {
  kIterations,
  kMaxModules,
  kMoveToNew,
  kMaxTerms,
  kMaxRules,
};
inline constexpr int kSettingCount = 5;

struct Setting {
  SettingKey key{};
  Value value;
};

/// `inclined = True` of an environment.
struct Entry {
  Span span;
  Span state;
  Value value;
};

struct Environment {
  Span name;
  Span open;
  Span close;
  Range entries;  ///< of File::entries
};

/// A module of an expected body, in the order of writing: a parent stands
/// before its children.
struct BodyNode {
  Span face;                ///< of the parent; empty for the first
  Span name;                ///< of the module's symbol
  Span open;                ///< '{', empty without children
  Span close;               ///< '}', likewise
  std::uint32_t depth = 0;  ///< 0 the first
};

/// `test NAME in ENVIRONMENT after 2 -> { ... }` or `-> body C { ... }`.
struct Test {
  Span name;
  Span environment;  ///< its name; empty without `in`
  bool has_after = false;
  Value after;  ///< rewritings, with has_after
  Span open;    ///< '{'; empty for a body of one module
  Span close;   ///< '}'
  Range symbols;
  Range nodes;  ///< of File::nodes; an expected body, instead of symbols
};

enum class ItemKind : std::uint8_t {
  kGenotype,
  kAlphabet,
  kSense,
  kLet,
  kAxiom,
  kSetting,
  kRule,
  kEnvironment,
  kTest,
};

/// One item; `index` into the vector of its kind.
struct Item {
  ItemKind kind{};
  Span span;
  Span keyword;
  std::uint32_t index = 0;
};

struct File {
  std::string_view text;
  Span version;  ///< `plsc 1`; empty when there is none
  Value version_number;
  std::vector<Item> items;

  std::vector<Naming> genotypes;
  std::vector<Alphabet> alphabets;
  std::vector<Sense> senses;
  std::vector<Let> lets;
  std::vector<Naming> axioms;
  std::vector<Setting> settings;
  std::vector<Rule> rules;
  std::vector<Environment> environments;
  std::vector<Test> tests;

  // Pools.
  std::vector<Symbol> symbols;
  std::vector<Value> arguments;
  std::vector<Term> terms;
  std::vector<Declaration> declarations;
  std::vector<Parameter> parameters;
  std::vector<Span> names;
  std::vector<Entry> entries;
  std::vector<BodyNode> nodes;

  std::vector<Span> comments;  ///< from '#' to before the line's end
  /// Some item could not be parsed, so what seems to be missing may be there.
  bool is_incomplete = false;

  std::string_view Text(Span span) const {
    return text.substr(span.begin, span.end - span.begin);
  }
};

template <typename T>
std::span<const T> Slice(const std::vector<T>& pool, Range range) {
  return std::span<const T>(pool).subspan(range.first, range.count);
}

}  // namespace plsc::ast
