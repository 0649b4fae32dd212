// The one line of Python that Revolve exports (plasticoding.py:153-156): the
// representation of a dictionary from letters to rules.

#include <fmt/format.h>

#include <string>
#include <unordered_map>
#include <utility>

#include "compiler/limits.h"
#include "grammar/keywords.h"
#include "runtime/authors/cursor.h"
#include "runtime/authors/genotype.h"

namespace plsc {

namespace {

class ReprReader {
 public:
  explicit ReprReader(const Source& source) : cursor_(source.text()) {}

  AuthorsText Read() {
    cursor_.Want("{", "at the start of the dictionary");
    if (!cursor_.Take("}")) {
      do ReadLetter();
      while (cursor_.Take(","));
      cursor_.Want("}", "at the end of the dictionary, or ',' and a letter");
    }
    cursor_.SkipBlanks();
    if (!cursor_.is_at_end())
      cursor_.Fail({cursor_.at(), cursor_.at() + 1}, "nothing more");
    if (cursor_.error()) read_.problems.push_back(*cursor_.error());
    return std::move(read_);
  }

 private:
  // <Alphabet.NAME: 'token'>
  AuthorsWord ReadName() {
    AuthorsWord word;
    cursor_.Want("<Alphabet.", "before a symbol's name");
    cursor_.Until(":>,", "a name in capitals");
    cursor_.Want(":", "behind the name");
    cursor_.Want("'", "before the symbol's token");
    const auto token = cursor_.Until("'\n", "a token");
    cursor_.Want("'", "behind the token");
    cursor_.Want(">", "behind the symbol");
    if (token) {
      word.span = *token;
      word.token = cursor_.Text(*token);
    }
    return word;
  }

  // <...>: [...]
  void ReadLetter() {
    const AuthorsWord letter = ReadName();
    cursor_.Want(":", "behind the letter");
    cursor_.Want("[", "before the letter's rules");
    if (cursor_.Take("]")) return AddEmpty(letter);
    // A flavour `[clause, rule]` begins with two lists, a symbol with one.
    const AuthorsCursor start = cursor_;
    const bool is_flavour = cursor_.Take("[") && cursor_.Take("[");
    cursor_ = start;
    if (!is_flavour) {
      read_.rules.push_back({letter, {}, letter.span, {}});
      ReadSymbols();
      return;
    }
    read_.has_clauses = true;
    do ReadFlavour(letter);
    while (cursor_.Take(","));
    cursor_.Want("]", "behind the letter's rules");
  }

  // An empty rule replaces nothing there, as a letter without a rule here.
  void AddEmpty(const AuthorsWord& letter) {
    if (!cursor_.has_failed())
      read_.rules.push_back({letter, {}, letter.span, {}});
  }

  void ReadFlavour(const AuthorsWord& letter) {
    AuthorsRule rule{letter, {}, {cursor_.at(), 0}, {}};
    cursor_.Want("[", "before a clause and its rule");
    cursor_.Want("[", "before a clause");
    if (!cursor_.Take("]")) ReadClause(&rule.clause);
    cursor_.Want(",", "between a clause and its rule");
    cursor_.Want("[", "before a rule");
    rule.span.end = cursor_.at();
    read_.rules.push_back(std::move(rule));
    if (!cursor_.Take("]")) ReadSymbols();
    cursor_.Want("]", "behind a clause and its rule");
  }

  // ['hill', '==', True], ['and'], ... ]
  void ReadClause(Clause* clause) {
    ReadTerm(clause);
    while (cursor_.Take(",")) {
      cursor_.Want("['", "before an operator");
      const bool is_and = cursor_.Take("and");
      if (!is_and) cursor_.Want("or", "or 'and'");
      clause->connectives.push_back(is_and ? Connective::kAnd
                                           : Connective::kOr);
      cursor_.Want("']", "behind an operator");
      cursor_.Want(",", "and a term behind an operator");
      ReadTerm(clause);
      if (cursor_.has_failed()) return;
    }
    cursor_.Want("]", "behind a clause");
  }

  void ReadTerm(Clause* clause) {
    cursor_.Want("['", "before a condition");
    const auto state = cursor_.Until("'\n", "a condition's name");
    if (state && !IsName(cursor_.Text(*state)))
      cursor_.Fail(*state, "a condition's name that is one of plsc's names");
    cursor_.Want("'", "behind a condition");
    cursor_.Want(",", "behind a condition");
    Term term;
    if (cursor_.Take("'!='"))
      term.comparison = plsc::Comparison::kNotEqual;
    else
      cursor_.Want("'=='", "or '!='");
    cursor_.Want(",", "behind the comparison");
    if (cursor_.Take("True"))
      term.value = 1;
    else
      cursor_.Want("False", "or 'True'");
    cursor_.Want("]", "behind a term");
    if (cursor_.has_failed()) return;
    if (read_.states.size() > kMaxStates) {
      cursor_.Fail(*state, fmt::format("at most {} conditions", kMaxStates));
      return;
    }
    term.state = StateOf(std::string(cursor_.Text(*state)));
    clause->terms.push_back(term);
  }

  StateId StateOf(const std::string& name) {
    const auto [known, is_new] =
        state_ids_.emplace(name, static_cast<StateId>(read_.states.size()));
    if (is_new) read_.states.push_back(name);
    return known->second;
  }

  // [<...>, [1, 2]], ... ]
  void ReadSymbols() {
    do {
      cursor_.Want("[", "before a symbol and its parameters");
      AuthorsWord word = ReadName();
      cursor_.Want(",", "behind a symbol");
      cursor_.Want("[", "before the parameters");
      if (!cursor_.Take("]")) {
        do {
          if (const auto number = cursor_.Number())
            word.parameters.push_back(*number);
        } while (cursor_.Take(","));
        cursor_.Want("]", "behind the parameters");
      }
      cursor_.Want("]", "behind a symbol and its parameters");
      if (cursor_.has_failed()) return;
      read_.rules.back().symbols.push_back(std::move(word));
    } while (cursor_.Take(","));
    cursor_.Want("]", "behind a rule");
  }

  AuthorsCursor cursor_;
  AuthorsText read_;
  std::unordered_map<std::string, StateId> state_ids_;
};

}  // namespace

AuthorsText ReadAuthorsRepr(const Source& source) {
  return ReprReader(source).Read();
}

}  // namespace plsc
