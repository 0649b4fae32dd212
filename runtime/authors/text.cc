// Writes what Revolve would export (plasticoding.py:153-156).

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "grammar/reporter.h"
#include "runtime/authors/genotype.h"

namespace plsc {

namespace {

Diagnostic Unsayable(std::string message) {
  return {Code::kNotAuthors, {}, std::move(message)};
}

// As Python prints a float: shortest, and with a point or an exponent. fmt
// changes to exponents where Python does.
std::string PythonFloat(double value) {
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

std::string SymbolText(SymbolId id) {
  const AuthorsSymbol& symbol = AuthorsSymbolOf(id);
  return fmt::format("<Alphabet.{}: '{}'>", symbol.python, symbol.token);
}

std::string RuleText(const std::vector<Symbol>& production) {
  std::vector<std::string> symbols;
  for (const Symbol& symbol : production) {
    const SymbolInfo& info = (*PlasticodingAlphabet())[symbol.id];
    const std::vector<double> values = AuthorsParameters(symbol);
    std::vector<std::string> numbers;
    for (std::size_t i = 0; i < values.size(); ++i)
      numbers.push_back(info.parameters[i].is_integer
                            ? fmt::format("{:.0f}", values[i])
                            : PythonFloat(values[i]));
    symbols.push_back(fmt::format("[{}, [{}]]", SymbolText(symbol.id),
                                  fmt::join(numbers, ", ")));
  }
  return fmt::format("[{}]", fmt::join(symbols, ", "));
}

std::string ClauseText(const Clause& clause, const Genotype& genotype) {
  std::string text;
  for (std::size_t i = 0; i < clause.terms.size(); ++i) {
    const Term& term = clause.terms[i];
    if (i > 0)
      text += clause.connectives[i - 1] == Connective::kAnd ? ", ['and'], "
                                                            : ", ['or'], ";
    text += fmt::format("['{}', '{}', {}]", genotype.StateOf(term.state).name,
                        term.comparison == Comparison::kEqual ? "==" : "!=",
                        term.value != 0 ? "True" : "False");
  }
  return fmt::format("[{}]", text);
}

std::vector<const Rule*> RulesOf(const Genotype& genotype, SymbolId letter) {
  std::vector<const Rule*> rules;
  for (const Rule& rule : genotype.rules)
    if (rule.head == letter) rules.push_back(&rule);
  return rules;
}

// What Revolve has no words for.
std::optional<Diagnostic> WhyNot(const Genotype& genotype, bool has_clauses) {
  if (!genotype.alphabet->is_built_in())
    return Unsayable("Revolve knows the alphabet 'plasticoding 1' only");
  for (const State& state : genotype.states)
    if (state.type != StateType::kBool)
      return Unsayable(
          fmt::format("Revolve's conditions are True or False, and '{}' is not",
                      state.name));
  for (const Rule& rule : genotype.rules) {
    const std::string& head = genotype.SymbolOf(rule.head).name;
    if (rule.clause.is_always() && has_clauses)
      return Unsayable(fmt::format(
          "in Revolve either every rule has a clause or none, and a rule of "
          "'{}' has none",
          head));
    if (!has_clauses && RulesOf(genotype, rule.head).size() > 1)
      return Unsayable(fmt::format(
          "without clauses Revolve has one rule a letter, and '{}' has more",
          head));
  }
  return std::nullopt;
}

std::vector<Diagnostic> Losses(const Genotype& genotype, bool has_clauses) {
  Reporter losses;
  if (genotype.development != DevelopmentSettings{})
    losses.Report(
        Code::kLost, {},
        "iterations, max_modules and move_to_new are not part of the "
        "text; Revolve has them in its experiments (3, 15, False in the "
        "paper's)");
  const int rules = has_clauses ? 2 : 1;
  if (genotype.max_rules.value_or(rules) != rules ||
      (has_clauses && genotype.max_terms.value_or(2) != 2))
    losses.Report(
        Code::kLost, {},
        "max_terms and max_rules are not part of the text; Revolve has "
        "them in its experiments (2 and 2 in the paper's)");
  return losses.Take();
}

}  // namespace

Result<std::string> AuthorsGenotypeText(const Genotype& genotype) {
  const bool has_clauses =
      std::any_of(genotype.rules.begin(), genotype.rules.end(),
                  [](const Rule& rule) { return !rule.clause.is_always(); });
  if (auto problem = WhyNot(genotype, has_clauses)) return *problem;
  std::vector<std::string> letters;
  for (const SymbolId letter : AuthorsLetters()) {
    std::vector<std::string> rules;
    for (const Rule* rule : RulesOf(genotype, letter))
      rules.push_back(has_clauses
                          ? fmt::format("[{}, {}]",
                                        ClauseText(rule->clause, genotype),
                                        RuleText(rule->production))
                          : RuleText(rule->production));
    std::string text = fmt::format("[{}]", fmt::join(rules, ", "));
    if (!has_clauses) text = rules.empty() ? "[]" : rules.front();
    letters.push_back(fmt::format("{}: {}", SymbolText(letter), text));
  }
  return {fmt::format("{{{}}}", fmt::join(letters, ", ")),
          Losses(genotype, has_clauses)};
}

}  // namespace plsc
