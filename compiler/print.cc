// The canonical text, of which two properties matter. It is complete: every
// value of the IR is written, so that compiling it gives an equal IR, bit for
// bit (std::to_chars writes the shortest text that reads back to the same
// double). And there is one: nothing depends on how the genotype came about.
// Keys, stores, requests to workers and comparisons are all made of it, so any
// change here, be it a blank, changes keys and the stores' texts.

#include "compiler/print.h"

#include <array>
#include <cmath>
#include <string_view>

#include "compiler/item_text.h"
#include "grammar/number.h"

namespace plsc {

namespace {

void AppendInt(std::int64_t value, std::string* text) {
  *text += std::to_string(value);
}

// Of an integer parameter: the shortest double may need an exponent (1e+15),
// which is no whole number in plsc.
void AppendArgument(double value, bool is_integer, std::string* text) {
  if (is_integer && value != 0)
    AppendInt(static_cast<std::int64_t>(value), text);
  else
    AppendNumber(value, text);
}

void AppendSymbol(const Symbol& symbol, const Alphabet& alphabet,
                  std::string* text) {
  const SymbolInfo& info = alphabet[symbol.id];
  *text += info.name;
  if (info.parameters.empty()) return;
  *text += '(';
  for (std::size_t i = 0; i < info.parameters.size(); ++i) {
    if (i > 0) *text += ", ";
    AppendArgument(symbol.arguments[i], info.parameters[i].is_integer, text);
  }
  *text += ')';
}

void AppendValue(double value, const State& state, std::string* text) {
  switch (state.type) {
    case StateType::kBool:
      *text += value != 0 ? "True" : "False";
      break;
    case StateType::kReal:
      AppendNumber(value, text);
      break;
    case StateType::kEnum:
      *text += state.values[static_cast<std::size_t>(value)];
      break;
  }
}

std::string_view ComparisonText(Comparison comparison) {
  static constexpr std::array<std::string_view, 6> kTexts = {
      " = ", " != ", " < ", " <= ", " > ", " >= "};
  return kTexts[static_cast<std::size_t>(comparison)];
}

void AppendClause(const Clause& clause, const std::vector<State>& states,
                  std::string* text) {
  for (std::size_t i = 0; i < clause.terms.size(); ++i) {
    if (i > 0)
      *text += clause.connectives[i - 1] == Connective::kAnd ? " and " : " or ";
    const Term& term = clause.terms[i];
    const State& state = StateAt(states, term.state);
    *text += state.name;
    *text += ComparisonText(term.comparison);
    AppendValue(term.value, state, text);
  }
}

void AppendSetting(std::string_view name, int value, std::string* text) {
  *text += name;
  *text += ' ';
  AppendInt(value, text);
  *text += '\n';
}

void AppendSense(const State& state, std::string* text) {
  *text += "sense " + state.name + ": ";
  switch (state.type) {
    case StateType::kBool:
      *text += "bool";
      break;
    case StateType::kReal:
      *text += "real in ";
      AppendNumber(state.low, text);
      *text += "..";
      AppendNumber(state.high, text);
      break;
    case StateType::kEnum:
      *text += "{ ";
      for (std::size_t i = 0; i < state.values.size(); ++i) {
        if (i > 0) *text += ", ";
        *text += state.values[i];
      }
      *text += " }";
      break;
  }
  *text += '\n';
}

void AppendHeader(const Genotype& genotype, std::string* text) {
  *text += "plsc 1\n\ngenotype " + genotype.name + "\n";
  *text += PrintAlphabet(*genotype.alphabet);
  for (const State& state : genotype.states) AppendSense(state, text);
  *text += "axiom " + genotype.SymbolOf(genotype.axiom).name + "\n";
  AppendSetting("iterations", genotype.development.iterations, text);
  AppendSetting("max_modules", genotype.development.max_modules, text);
  *text += genotype.development.move_to_new ? "move_to_new True\n"
                                            : "move_to_new False\n";
  if (genotype.max_terms) AppendSetting("max_terms", *genotype.max_terms, text);
  if (genotype.max_rules) AppendSetting("max_rules", *genotype.max_rules, text);
}

void AppendRule(const Rule& rule, const Genotype& genotype, std::string* text) {
  *text += "\nrule " + genotype.SymbolOf(rule.head).name + " -> ";
  if (!rule.clause.is_always()) {
    *text += "if ";
    AppendClause(rule.clause, genotype.states, text);
    *text += " then ";
  }
  *text += "{\n";
  for (const Symbol& symbol : rule.production) {
    *text += "  ";
    AppendSymbol(symbol, *genotype.alphabet, text);
    *text += '\n';
  }
  *text += "}\n";
}

void AppendEntries(const Environment& environment,
                   const std::vector<State>& states, bool is_spaced,
                   std::string* text) {
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (i > 0) *text += is_spaced ? ", " : ",";
    *text += states[i].name;
    *text += is_spaced ? " = " : "=";
    AppendValue(environment.values[i], states[i], text);
  }
}

// On the line that `text` ends in when that fits, else a symbol a line.
void AppendExpectedString(const InlineTest& test, const Alphabet& alphabet,
                          std::string* text) {
  std::vector<std::string> symbols;
  std::size_t width = text->size() - text->rfind('\n') - 1;
  for (const ExpectedSymbol& expected : test.string) {
    symbols.emplace_back();
    if (expected.has_arguments)
      AppendSymbol(expected.symbol, alphabet, &symbols.back());
    else
      symbols.back() = alphabet[expected.symbol.id].name;
    width += 1 + symbols.back().size();
  }
  const bool is_one_line = width + 3 <= kLineWidth;  // "{", " }"
  *text += is_one_line ? "{" : "{\n";
  for (const std::string& symbol : symbols) {
    *text += is_one_line ? " " : "  ";
    *text += symbol;
    if (!is_one_line) *text += '\n';
  }
  *text += is_one_line ? " }\n" : "}\n";
}

void AppendExpectedBody(const std::vector<ExpectedModule>& body,
                        const Alphabet& alphabet, std::string* text) {
  *text += "body ";
  for (std::size_t i = 0; i < body.size(); ++i) {
    const ExpectedModule& module = body[i];
    const auto indent = 2 * static_cast<std::size_t>(module.depth);
    text->append(indent, ' ');
    if (module.depth > 0) {
      *text += NameIn(kFaceNames, module.face);
      *text += ' ';
    }
    *text += alphabet[module.symbol].name;
    const int next = i + 1 < body.size() ? body[i + 1].depth : 0;
    *text += next > module.depth ? " {\n" : "\n";
    for (int depth = module.depth; depth-- > next;) {
      text->append(2 * static_cast<std::size_t>(depth), ' ');
      *text += "}\n";
    }
  }
}

void AppendTest(const InlineTest& test, const Genotype& genotype,
                std::string* text) {
  *text += "\ntest " + test.name;
  if (!test.place.empty()) *text += " in " + test.place;
  if (test.after) {
    *text += " after ";
    AppendInt(*test.after, text);
  }
  *text += " -> ";
  if (test.body.empty())
    AppendExpectedString(test, *genotype.alphabet, text);
  else
    AppendExpectedBody(test.body, *genotype.alphabet, text);
}

std::string PrintBound(const Parameter& parameter, double bound) {
  if (!parameter.is_integer || bound == 0) return PrintNumber(bound);
  return std::to_string(static_cast<long long>(bound));
}

std::string PrintParameter(const Parameter& parameter) {
  std::string text = parameter.name;
  text += parameter.is_integer ? ": int" : ": real";
  if (std::isfinite(parameter.low))
    text += " in " + PrintBound(parameter, parameter.low) + ".." +
            PrintBound(parameter, parameter.high);
  return text;
}

std::string PrintDeclaration(const SymbolInfo& symbol) {
  std::string text = symbol.name;
  for (std::size_t i = 0; i < symbol.parameters.size(); ++i) {
    text += i == 0 ? "(" : ", ";
    text += PrintParameter(symbol.parameters[i]);
  }
  if (!symbol.parameters.empty()) text += ")";
  return text;
}

}  // namespace

std::string PrintAlphabet(const Alphabet& alphabet) {
  std::string text = "alphabet " + alphabet.name();
  if (alphabet.is_built_in())
    return text + " " + std::to_string(alphabet.version()) + "\n";
  text += " {";
  const std::vector<SymbolInfo>& symbols = alphabet.symbols();
  for (std::size_t i = 0; i < symbols.size(); ++i) {
    // The order of symbols is their numbering, so groups may alternate.
    const bool is_new_group =
        i == 0 || symbols[i].is_replaceable != symbols[i - 1].is_replaceable;
    if (is_new_group) {
      text += i == 0 ? "\n  " : ";\n  ";
      text += symbols[i].is_replaceable ? "replaceable " : "terminal ";
    } else {
      text += ", ";
    }
    text += PrintDeclaration(symbols[i]);
  }
  return text + "\n}\n";
}

std::string Print(const Genotype& genotype) {
  std::string text;
  AppendHeader(genotype, &text);
  for (const Rule& rule : genotype.rules) AppendRule(rule, genotype, &text);
  return text;
}

std::string Print(const Program& program) {
  std::string text = Print(program.genotype);
  const std::vector<State>& states = program.genotype.states;
  if (!program.environments.empty()) text += '\n';
  for (const NamedEnvironment& named : program.environments) {
    text += "environment " + named.name + " {";
    if (!states.empty()) text += ' ';
    AppendEntries(named.environment, states, true, &text);
    text += states.empty() ? "}\n" : " }\n";
  }
  for (const InlineTest& test : program.tests)
    AppendTest(test, program.genotype, &text);
  return text;
}

std::string PrintClause(const Clause& clause, const Genotype& genotype) {
  std::string text;
  AppendClause(clause, genotype.states, &text);
  return text;
}

std::string PrintSymbol(const Symbol& symbol, const Alphabet& alphabet) {
  std::string text;
  AppendSymbol(symbol, alphabet, &text);
  return text;
}

std::string PrintBody(const std::vector<ExpectedModule>& body,
                      const Alphabet& alphabet) {
  std::string text;
  for (std::size_t i = 0; i < body.size(); ++i) {
    const ExpectedModule& module = body[i];
    if (module.depth > 0) {
      text += ' ';
      text += NameIn(kFaceNames, module.face);
      text += ' ';
    }
    text += alphabet[module.symbol].name;
    const int next = i + 1 < body.size() ? body[i + 1].depth : 0;
    if (next > module.depth) text += " {";
    for (int depth = module.depth; depth > next; --depth) text += " }";
  }
  return text;
}

std::string PrintEnvironment(const Environment& environment,
                             const std::vector<State>& states) {
  std::string text;
  AppendEntries(environment, states, false, &text);
  return text;
}

}  // namespace plsc
