#pragma once

// A grammar as data, and how it is written down: the EBNF of docs/language.md.
// ebnf_of.h makes it from the types that the parser is made of, so that the
// reference cannot say anything else than what is parsed.

#include <map>
#include <string>
#include <vector>

namespace plsc::testing {

/// What one side of a rule says.
struct Ebnf {
  enum class Kind {
    kEmpty,     ///< nothing that a reader sees, such as a look ahead
    kTerminal,  ///< `text` as it is printed: "rule", ? U+FEFF ?
    kRule,      ///< the rule with the key `text`
    kSequence,
    kChoice,
    kRepeat,    ///< of the only part, any number of times
    kOptional,  ///< the only part
  };
  Kind kind = Kind::kEmpty;
  std::string text;
  std::vector<Ebnf> parts;

  bool operator==(const Ebnf&) const = default;
};

struct EbnfRule {
  /// The rules of one definition under different names, which the parser
  /// needs to tell places apart, are one rule to a reader: the first of
  /// EbnfGrammar::names here, else the shortest.
  std::vector<std::string> names;
  Ebnf body;
};

struct EbnfGrammar {
  std::string start;                 ///< key of the rule to begin with
  std::vector<std::string> lexical;  ///< keys of rules to end with
  /// What rules are called where the parser's name would not do.
  std::map<std::string, std::string> names;
  std::map<std::string, EbnfRule> rules;
};

/// The rules that can be reached, one a paragraph of at most 80 columns: those
/// from the start first, each before those it uses. A rule that is only one
/// terminal or another rule is written where it is used, and so is one whose
/// name ends in _word.
std::string PrintEbnf(const EbnfGrammar& grammar);

}  // namespace plsc::testing
