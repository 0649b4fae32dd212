#include "compiler/random_genotype.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>
#include <string>

#include "compiler/own_alphabet.h"

namespace plsc::testing {

namespace {

class Generator {
 public:
  explicit Generator(std::uint32_t seed) : engine_(seed) {}

  Program Make() {
    Program program;
    Genotype& genotype = program.genotype;
    genotype.name = Name("g");
    if (Chance(3)) genotype.alphabet = MakeAlphabet();
    const int states = Below(4);
    for (int i = 0; i < states; ++i)
      genotype.states.push_back(MakeState("s" + std::to_string(i)));
    genotype.development = {Below(101), 1 + Below(1000), Chance(2)};
    if (Chance(2)) genotype.max_terms = 3 + Below(100);
    if (Chance(2)) genotype.max_rules = 8 + Below(100);
    MakeRules(&genotype);
    const int environments = Below(3);
    for (int i = 0; i < environments; ++i)
      program.environments.push_back(
          {"e" + std::to_string(i), MakeEnvironment(genotype)});
    MakeTests(&program);
    return program;
  }

 private:
  int Below(int n) {
    return static_cast<int>(engine_() % static_cast<unsigned>(n));
  }
  bool Chance(int n) { return Below(n) == 0; }
  std::string Name(const char* prefix) {
    return prefix + std::to_string(Below(1000));
  }

  // Any finite double: all exponents, both zeros, denormals.
  double AnyDouble() {
    while (true) {
      const std::uint64_t high = engine_();
      const auto value = std::bit_cast<double>(high << 32U | engine_());
      if (Chance(20)) return Chance(2) ? -0.0 : 0.0;
      if (std::isfinite(value)) return value;
    }
  }

  double Between(double low, double high) {
    const double value =
        low + (high - low) * (static_cast<double>(engine_()) / 4294967295.0);
    return std::clamp(value, low, high);
  }

  AlphabetPtr MakeAlphabet() {
    std::vector<SymbolInfo> symbols;
    const int count = 2 + Below(6);
    for (int i = 0; i < count; ++i) {
      SymbolInfo symbol;
      symbol.name = "x" + std::to_string(i);
      // The first is the axiom and has no parameters.
      symbol.is_replaceable = i == 0 || Chance(2);
      symbol.category =
          symbol.is_replaceable ? Category::kModule : Category::kTerminal;
      const int parameters = i == 0 ? 0 : Below(kMaxParameters + 1);
      for (int k = 0; k < parameters; ++k)
        symbol.parameters.push_back(MakeParameter(k));
      symbols.push_back(std::move(symbol));
    }
    return std::make_shared<const Alphabet>("own", 0, std::move(symbols));
  }

  Parameter MakeParameter(int k) {
    Parameter parameter;
    parameter.name = "p" + std::to_string(k);
    parameter.is_integer = Chance(2);
    if (Chance(2)) {
      const double a = AnyDouble();
      const double b = AnyDouble();
      const double scale = 9007199254740992.0;
      parameter.low =
          parameter.is_integer ? -Below(100) * 1e13 : std::min(a, b);
      parameter.high = parameter.is_integer ? scale : std::max(a, b);
    }
    parameter.sampling = DefaultSampling(parameter);
    return parameter;
  }

  State MakeState(std::string name) {
    State state;
    state.name = std::move(name);
    state.type = static_cast<StateType>(Below(3));
    if (state.type == StateType::kReal) {
      state.low = Between(-1e3, 0);
      state.high = Between(1, 1e6);
    }
    if (state.type == StateType::kEnum) {
      const int values = 2 + Below(3);
      for (int i = 0; i < values; ++i)
        state.values.push_back("v" + std::to_string(i));
    }
    return state;
  }

  double ValueOf(const State& state) {
    switch (state.type) {
      case StateType::kBool:
        return Below(2);
      case StateType::kReal:
        return Between(state.low, state.high);
      case StateType::kEnum:
        break;
    }
    return Below(static_cast<int>(state.values.size()));
  }

  Environment MakeEnvironment(const Genotype& genotype) {
    Environment environment;
    for (const State& state : genotype.states)
      environment.values.push_back(ValueOf(state));
    return environment;
  }

  Clause MakeClause(const std::vector<State>& states) {
    Clause clause;
    if (states.empty()) return clause;
    const int terms = Below(4);
    for (int i = 0; i < terms; ++i) {
      Term term;
      term.state = static_cast<StateId>(Below(static_cast<int>(states.size())));
      const State& state = states[static_cast<std::size_t>(term.state)];
      const bool is_real = state.type == StateType::kReal;
      term.comparison = static_cast<Comparison>(Below(is_real ? 6 : 2));
      term.value = is_real && Chance(3) ? AnyDouble() : ValueOf(state);
      if (i > 0)
        clause.connectives.push_back(Chance(2) ? Connective::kAnd
                                               : Connective::kOr);
      clause.terms.push_back(term);
    }
    return clause;
  }

  double ArgumentOf(const Parameter& parameter) {
    const bool is_bounded = std::isfinite(parameter.low);
    const bool is_above = is_bounded && std::isfinite(parameter.high);
    if (parameter.is_integer) {
      const double low = is_bounded ? parameter.low : -1e15;
      const double high = is_above ? parameter.high : low + 1e15;
      return std::trunc(Chance(5) ? high : Between(low, high));
    }
    if (!is_bounded) return AnyDouble();
    const double value = AnyDouble();
    if (value >= parameter.low && value <= parameter.high) return value;
    return Chance(2) ? parameter.low : parameter.high;
  }

  Symbol MakeSymbol(const Alphabet& alphabet, SymbolId id) {
    Symbol symbol;
    symbol.id = id;
    const std::vector<Parameter>& parameters = alphabet[id].parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i)
      symbol.arguments[i] = ArgumentOf(parameters[i]);
    return symbol;
  }

  void MakeTests(Program* program) {
    const Genotype& genotype = program->genotype;
    const auto& environments = program->environments;
    if (environments.empty() && !genotype.states.empty()) return;
    for (int count = Below(3); count > 0; --count) {
      InlineTest test;
      test.name = "t" + std::to_string(count);
      if (!environments.empty()) {
        const NamedEnvironment& named = environments[static_cast<std::size_t>(
            Below(static_cast<int>(environments.size())))];
        test.place = named.name;
        test.environment = named.environment;
      }
      if (Chance(2)) test.after = Below(genotype.development.iterations + 1);
      if (genotype.alphabet->is_built_in() && Chance(2))
        MakeBody(plasticoding::kC, 0, Face::kFront, &test.body);
      else
        MakeString(*genotype.alphabet, &test.string);
      program->tests.push_back(std::move(test));
    }
  }

  void MakeString(const Alphabet& alphabet,
                  std::vector<ExpectedSymbol>* string) {
    for (int symbols = 1 + Below(5); symbols > 0; --symbols) {
      const auto id = static_cast<SymbolId>(
          Below(static_cast<int>(alphabet.symbols().size())));
      ExpectedSymbol expected{MakeSymbol(alphabet, id), true};
      if (Chance(3) && !alphabet[id].parameters.empty())
        expected = {Symbol{id, {}}, false};
      string->push_back(expected);
    }
  }

  void MakeBody(SymbolId module, int depth, Face face,
                std::vector<ExpectedModule>* body) {
    body->push_back({module, depth, face});
    if (depth == 4 || module == plasticoding::kT) return;
    const bool is_joint =
        module == plasticoding::kA1 || module == plasticoding::kA2;
    for (int f = 0; f < (is_joint ? 1 : kFaces); ++f)
      if (Chance(3))
        MakeBody(static_cast<SymbolId>(1 + Below(4)), depth + 1,
                 static_cast<Face>(f), body);
  }

  void MakeRules(Genotype* genotype) {
    const Alphabet& alphabet = *genotype->alphabet;
    const int count = static_cast<int>(alphabet.symbols().size());
    for (int head = 0; head < count; ++head) {
      const auto id = static_cast<SymbolId>(head);
      if (!alphabet[id].is_replaceable) continue;
      for (int rules = Below(4); rules > 0; --rules) {
        Rule rule;
        rule.head = id;
        rule.clause = MakeClause(genotype->states);
        const bool is_core = alphabet.is_built_in() && head == 0;
        if (is_core) rule.production.push_back(Symbol{id, {}});
        for (int symbols = 1 + Below(8); symbols > 0; --symbols) {
          const int first = alphabet.is_built_in() ? 1 : 0;
          const auto symbol =
              static_cast<SymbolId>(first + Below(count - first));
          rule.production.push_back(MakeSymbol(alphabet, symbol));
        }
        genotype->rules.push_back(std::move(rule));
      }
    }
  }

  std::mt19937 engine_;  // NOLINT(bugprone-random-generator-seed)
};

}  // namespace

Program RandomProgram(std::uint32_t seed) {
  return Generator(seed).Make();
}

}  // namespace plsc::testing
