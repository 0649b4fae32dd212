// What must be true of a genotype whoever made it, in one place and apart from
// the compiler: its checks speak to users about a text, these speak to us about
// values that have none (evolved, crossed, imported, read from a store).
// Whatever passes can be printed, compiled to an equal value, and developed
// without further checks; development and evolution index by state, symbol and
// rule and would read beyond their arrays if this were wrong.
//
// Two of the conditions look like pedantry and are about bits. A zero must be
// positive where the value is a choice (bool and enum states, unused
// arguments): -0 equals 0 but is not written as such, and what is read back
// would differ from it in a bit. Whole numbers stay within 2^53, beyond which a
// double no longer is the number that was written.
//
// One pass, linear in the IR; sentences are made only where something fails, as
// tests and fuzzers ask of very many genotypes in which nothing does.

#include "compiler/verify.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "compiler/limits.h"
#include "grammar/keywords.h"

namespace plsc {

namespace {

// What is wrong so far; at most a few sentences are of use.
class Findings {
 public:
  void Expect(bool holds, const auto& sentence) {
    if (!holds && sentences_.size() < kMaxSentences)
      sentences_.push_back(sentence());
  }
  bool is_empty() const { return sentences_.empty(); }
  std::vector<std::string> Take() { return std::move(sentences_); }

 private:
  static constexpr std::size_t kMaxSentences = 100;
  std::vector<std::string> sentences_;
};

void VerifyName(const std::string& name, const char* what, Findings* found) {
  found->Expect(IsName(name), [&] {
    return fmt::format("{} '{}' is not a name", what, name);
  });
}

// A parameter without a range has infinite bounds, both.
void VerifyParameter(const Parameter& parameter, Findings* found) {
  VerifyName(parameter.name, "parameter", found);
  const bool has_low = std::isfinite(parameter.low);
  found->Expect(has_low == std::isfinite(parameter.high), [&] {
    return fmt::format("parameter '{}' has only one bound", parameter.name);
  });
  const bool is_whole = !parameter.is_integer || !has_low ||
                        (std::trunc(parameter.low) == parameter.low &&
                         std::trunc(parameter.high) == parameter.high &&
                         std::abs(parameter.low) <= kMaxWholeNumber &&
                         std::abs(parameter.high) <= kMaxWholeNumber);
  found->Expect(is_whole && !(parameter.low > parameter.high), [&] {
    return fmt::format("parameter '{}' has a wrong range", parameter.name);
  });
}

// The built-in alphabet is right by its own test.
void VerifyAlphabet(const Alphabet& alphabet, Findings* found) {
  if (alphabet.is_built_in()) {
    found->Expect(&alphabet == PlasticodingAlphabet().get() ||
                      alphabet == *PlasticodingAlphabet(),
                  [] { return "the alphabet only claims to be built in"; });
    return;
  }
  VerifyName(alphabet.name(), "alphabet", found);
  found->Expect(alphabet.name() != PlasticodingAlphabet()->name(),
                [] { return "the alphabet's name is that of a built-in one"; });
  const std::size_t count = alphabet.symbols().size();
  found->Expect(count > 0 && count <= kMaxSymbols, [&] {
    return fmt::format("the alphabet has {} symbols", count);
  });
  std::set<std::string_view> names;
  for (const SymbolInfo& symbol : alphabet.symbols()) {
    VerifyName(symbol.name, "symbol", found);
    found->Expect(names.insert(symbol.name).second, [&] {
      return fmt::format("symbol '{}' is declared twice", symbol.name);
    });
    std::set<std::string_view> parameters;
    for (const Parameter& parameter : symbol.parameters) {
      VerifyParameter(parameter, found);
      found->Expect(parameters.insert(parameter.name).second, [&] {
        return fmt::format("parameter '{}' of '{}' is declared twice",
                           parameter.name, symbol.name);
      });
    }
  }
}

void VerifyState(const State& state, Findings* found) {
  VerifyName(state.name, "state", found);
  if (state.type == StateType::kReal) {
    found->Expect(std::isfinite(state.low) && std::isfinite(state.high) &&
                      state.low < state.high,
                  [&] {
                    return fmt::format("state '{}' has an empty range",
                                       state.name);
                  });
  }
  if (state.type == StateType::kEnum) {
    const std::set<std::string> unique(state.values.begin(),
                                       state.values.end());
    found->Expect(state.values.size() >= 2 &&
                      state.values.size() <= kMaxSymbols &&
                      unique.size() == state.values.size(),
                  [&] {
                    return fmt::format(
                        "state '{}' needs two or more "
                        "different values",
                        state.name);
                  });
    for (const std::string& value : state.values)
      VerifyName(value, "value", found);
  }
}

void VerifyStates(const std::vector<State>& states, Findings* found) {
  found->Expect(states.size() <= kMaxStates, [&] {
    return fmt::format("there are {} states", states.size());
  });
  std::set<std::string_view> names;
  for (const State& state : states) {
    VerifyState(state, found);
    found->Expect(names.insert(state.name).second, [&] {
      return fmt::format("state '{}' is declared twice", state.name);
    });
  }
}

// Whether `value` is one that the state can have, or be compared with.
bool IsValueOf(const State& state, double value) {
  switch (state.type) {
    case StateType::kBool:
      return (value == 0 || value == 1) && !std::signbit(value);
    case StateType::kReal:
      return std::isfinite(value);
    case StateType::kEnum:
      return value >= 0 && !std::signbit(value) &&
             value < static_cast<double>(state.values.size()) &&
             std::trunc(value) == value;
  }
  return false;
}

void VerifyClause(const Clause& clause, const std::vector<State>& states,
                  Findings* found) {
  const std::size_t wanted = clause.terms.empty() ? 0 : clause.terms.size() - 1;
  found->Expect(clause.connectives.size() == wanted, [&] {
    return fmt::format("a clause of {} terms has {} connectives",
                       clause.terms.size(), clause.connectives.size());
  });
  for (const Term& term : clause.terms) {
    const auto index = static_cast<std::size_t>(term.state);
    if (index >= states.size()) {
      found->Expect(false, [&] {
        return fmt::format("a term asks about state number {}", index);
      });
      continue;
    }
    const State& state = states[index];
    found->Expect(IsValueOf(state, term.value), [&] {
      return fmt::format("a term compares '{}' with {}", state.name,
                         term.value);
    });
    found->Expect(state.type == StateType::kReal ||
                      term.comparison <= Comparison::kNotEqual,
                  [&] {
                    return fmt::format("a term orders the values of '{}'",
                                       state.name);
                  });
  }
}

void VerifySymbol(const Symbol& symbol, const Alphabet& alphabet,
                  Findings* found) {
  const std::vector<Parameter>& parameters = alphabet[symbol.id].parameters;
  for (std::size_t i = 0; i < symbol.arguments.size(); ++i) {
    const double value = symbol.arguments[i];
    // Behind a symbol's parameters there is nothing, in one way: symbols are
    // compared and hashed with all their places.
    bool is_right = value == 0 && !std::signbit(value);
    if (i < parameters.size()) {
      const Parameter& p = parameters[i];
      is_right = std::isfinite(value) && value >= p.low && value <= p.high &&
                 (!p.is_integer || (std::trunc(value) == value &&
                                    std::abs(value) <= kMaxWholeNumber));
    }
    found->Expect(is_right, [&] {
      return fmt::format("argument {} of '{}' is {}", i + 1,
                         alphabet[symbol.id].name, value);
    });
  }
}

// One core: first in every production of C, and nowhere else.
void VerifyCore(const Rule& rule, Findings* found) {
  const bool is_core_rule = rule.head == plasticoding::kC;
  for (std::size_t i = 0; i < rule.production.size(); ++i)
    found->Expect(
        (rule.production[i].id == plasticoding::kC) == (is_core_rule && i == 0),
        [] {
          return "C must be the first symbol of every rule for C "
                 "and occur nowhere else";
        });
}

void VerifyRule(const Rule& rule, const Genotype& genotype, Findings* found) {
  const Alphabet& alphabet = *genotype.alphabet;
  const auto is_known = [&](SymbolId id) {
    return static_cast<std::size_t>(id) < alphabet.symbols().size();
  };
  // All that follows looks the head up.
  if (!is_known(rule.head)) {
    found->Expect(false, [] { return "a rule has an unknown head"; });
    return;
  }
  found->Expect(alphabet[rule.head].is_replaceable, [&] {
    return fmt::format("'{}' is not replaceable", alphabet[rule.head].name);
  });
  found->Expect(!rule.production.empty(),
                [] { return "a production is empty"; });
  VerifyClause(rule.clause, genotype.states, found);
  found->Expect(
      !genotype.max_terms || rule.clause.terms.size() <=
                                 static_cast<std::size_t>(*genotype.max_terms),
      [&] {
        return fmt::format("a clause has {} terms", rule.clause.terms.size());
      });
  for (const Symbol& symbol : rule.production) {
    if (is_known(symbol.id))
      VerifySymbol(symbol, alphabet, found);
    else
      found->Expect(false, [] { return "a production has unknown symbols"; });
  }
  if (alphabet.is_built_in()) VerifyCore(rule, found);
}

void VerifyRules(const Genotype& genotype, Findings* found) {
  found->Expect(genotype.rules.size() <= kMaxRuleCount, [&] {
    return fmt::format("there are {} rules", genotype.rules.size());
  });
  // Regulation, printing and crossover take the rules of a symbol as a run.
  const auto by_head = [](const Rule& a, const Rule& b) {
    return a.head < b.head;
  };
  found->Expect(
      std::is_sorted(genotype.rules.begin(), genotype.rules.end(), by_head),
      [] { return "rules are not grouped in alphabet order"; });
  std::map<SymbolId, int> counts;
  for (const Rule& rule : genotype.rules) {
    VerifyRule(rule, genotype, found);
    found->Expect(
        !genotype.max_rules || ++counts[rule.head] <= *genotype.max_rules,
        [] { return "a symbol has more than max_rules rules"; });
  }
}

void VerifySettings(const Genotype& genotype, Findings* found) {
  const auto in = [](int value, int low, int high) {
    return value >= low && value <= high;
  };
  const DevelopmentSettings& development = genotype.development;
  found->Expect(in(development.iterations, kMinIterations, kMaxIterations),
                [] { return "iterations is out of range"; });
  found->Expect(in(development.max_modules, kMinModules, kMaxModules),
                [] { return "max_modules is out of range"; });
  found->Expect(in(genotype.max_terms.value_or(1), kMinLimit, kMaxLimit),
                [] { return "max_terms is out of range"; });
  found->Expect(in(genotype.max_rules.value_or(1), kMinLimit, kMaxLimit),
                [] { return "max_rules is out of range"; });
}

void VerifyAxiom(const Genotype& genotype, Findings* found) {
  const Alphabet& alphabet = *genotype.alphabet;
  const auto axiom = static_cast<std::size_t>(genotype.axiom);
  if (axiom >= alphabet.symbols().size()) {
    found->Expect(false, [] { return "the axiom is unknown"; });
    return;
  }
  found->Expect(alphabet[genotype.axiom].parameters.empty(),
                [] { return "the axiom has parameters"; });
  found->Expect(!alphabet.is_built_in() || genotype.axiom == plasticoding::kC,
                [] { return "the axiom is not C"; });
}

void VerifyGenotype(const Genotype& genotype, Findings* found) {
  if (genotype.alphabet == nullptr) {
    found->Expect(false, [] { return "there is no alphabet"; });
    return;
  }
  found->Expect(IsGenotypeName(genotype.name), [&] {
    return fmt::format("genotype '{}' is not a name", genotype.name);
  });
  VerifyAlphabet(*genotype.alphabet, found);
  VerifyStates(genotype.states, found);
  VerifyAxiom(genotype, found);
  VerifySettings(genotype, found);
  VerifyRules(genotype, found);
}

void VerifyEnvironments(const Program& program, Findings* found) {
  const std::vector<State>& states = program.genotype.states;
  std::set<std::string_view> names;
  for (const NamedEnvironment& named : program.environments) {
    VerifyName(named.name, "environment", found);
    found->Expect(names.insert(named.name).second, [&] {
      return fmt::format("environment '{}' is declared twice", named.name);
    });
    const std::vector<double>& values = named.environment.values;
    bool is_right = values.size() == states.size();
    for (std::size_t i = 0; is_right && i < values.size(); ++i)
      is_right = IsValueOf(states[i], values[i]) &&
                 (states[i].type != StateType::kReal ||
                  (values[i] >= states[i].low && values[i] <= states[i].high));
    found->Expect(is_right, [&] {
      return fmt::format("environment '{}' has wrong values", named.name);
    });
  }
}

// Whether depths are those of a walk through one tree, the core its root: a
// module is at most one deeper than the one before it.
bool IsExpectedBody(const std::vector<ExpectedModule>& body,
                    const Alphabet& alphabet) {
  int last_depth = -1;
  for (const ExpectedModule& module : body) {
    const bool is_core = module.symbol == plasticoding::kC;
    if (module.depth > last_depth + 1 || module.depth < 0 ||
        is_core != (module.depth == 0) ||
        (module.depth == 0 && last_depth >= 0) ||
        alphabet[module.symbol].category != Category::kModule)
      return false;
    last_depth = module.depth;
  }
  return true;
}

void VerifyTest(const InlineTest& test, const Program& program,
                Findings* found) {
  const Genotype& genotype = program.genotype;
  const auto named = std::find_if(
      program.environments.begin(), program.environments.end(),
      [&](const NamedEnvironment& e) { return e.name == test.place; });
  // A test has its environment by name and by value, which must not part.
  const bool is_placed = named != program.environments.end()
                             ? named->environment == test.environment
                             : test.place.empty() && genotype.states.empty();
  const int after = test.after.value_or(0);
  const bool is_right =
      is_placed && after >= 0 && after <= genotype.development.iterations &&
      test.string.empty() != test.body.empty() &&
      (test.body.empty() || (genotype.alphabet->is_built_in() &&
                             IsExpectedBody(test.body, *genotype.alphabet)));
  found->Expect(is_right,
                [&] { return fmt::format("test '{}' is wrong", test.name); });
}

void VerifyTests(const Program& program, Findings* found) {
  std::set<std::string_view> names;
  for (const InlineTest& test : program.tests) {
    VerifyName(test.name, "test", found);
    found->Expect(names.insert(test.name).second, [&] {
      return fmt::format("test '{}' is declared twice", test.name);
    });
    if (program.genotype.alphabet != nullptr) VerifyTest(test, program, found);
  }
}

}  // namespace

std::vector<std::string> Verify(const Genotype& genotype) {
  Findings found;
  VerifyGenotype(genotype, &found);
  return found.Take();
}

std::vector<std::string> Verify(const Program& program) {
  Findings found;
  VerifyGenotype(program.genotype, &found);
  VerifyEnvironments(program, &found);
  VerifyTests(program, &found);
  return found.Take();
}

}  // namespace plsc
