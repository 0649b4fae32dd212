// Every name in rules, environments and tests becomes a number, in arrays
// parallel to the pools of the tree: symbol i of the file is symbol i of the
// result. The tree itself stays as it was written, which diagnostics, the
// formatter and the language server need. What cannot be found is reported here
// and left empty; the stages behind skip what is empty, so that a mistake is
// told once, by the first stage that can see it.
//
// Finding is one look into a hash table a name. Expensive is what is said about
// names that are not found, a search for similar ones among all that exist
// (grammar/suggest). It is done only for reports that are kept, kMaxReported at
// most, however many names of a file are unknown.

#include "compiler/resolve.h"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "compiler/foreign_names.h"
#include "compiler/limits.h"
#include "grammar/number.h"
#include "grammar/number_error.h"
#include "grammar/reporter.h"
#include "grammar/suggest.h"

namespace plsc {

namespace {

template <typename T, typename Name>
std::vector<std::string_view> NamesOf(const std::vector<T>& things, Name name) {
  std::vector<std::string_view> names;
  names.reserve(things.size());
  for (const T& thing : things) names.push_back(name(thing));
  return names;
}

class Resolver {
 public:
  Resolver(const ast::File& file, const Scope& scope)
      : file_(file), scope_(scope) {
    result_.heads.resize(file.rules.size());
    result_.symbols.resize(file.symbols.size());
    result_.arguments.resize(file.arguments.size());
    result_.terms.resize(file.terms.size());
    result_.entries.resize(file.entries.size());
    result_.nodes.resize(file.nodes.size());
  }

  Resolution Resolve() {
    for (std::size_t i = 0; i < file_.rules.size(); ++i) ResolveRule(i);
    for (const ast::Environment& environment : file_.environments)
      for (std::uint32_t k = 0; k < environment.entries.count; ++k) {
        const std::uint32_t at = environment.entries.first + k;
        const ast::Entry& entry = file_.entries[at];
        result_.entries[at] = ResolveTerm(entry.state, entry.value);
      }
    for (const ast::Test& test : file_.tests) ResolveTest(test);
    result_.diagnostics = reporter_.Take();
    return std::move(result_);
  }

 private:
  void SuggestAmong(const std::vector<std::string_view>& known,
                    Diagnostic* diagnostic) {
    AddSuggestion(file_.Text(diagnostic->span), known, diagnostic);
  }

  void ResolveRule(std::size_t index) {
    const ast::Rule& rule = file_.rules[index];
    result_.heads[index] = ResolveSymbol(rule.head);
    for (std::uint32_t k = 0; k < rule.terms.count; ++k) {
      const ast::Term& term = file_.terms[rule.terms.first + k];
      ResolvedTerm& resolved = result_.terms[rule.terms.first + k];
      resolved = ResolveTerm(term.state, term.value);
      if (!resolved) continue;
      // The tree's operators and the IR's are in the same order.
      resolved->comparison = static_cast<Comparison>(term.comparison);
      if (!IsOrdered(resolved->state) && term.comparison != kEqual &&
          term.comparison != kNotEqual) {
        // Nothing behind could tell in which environments it holds.
        resolved.reset();
        if (reporter_.is_full()) continue;
        reporter_
            .Report(Code::kValueType, term.comparison_span,
                    fmt::format("'{}' cannot be compared with '{}'",
                                file_.Text(term.state),
                                file_.Text(term.comparison_span)))
            .WithLabel("only '=' and '!=' here");
      }
    }
    ResolveSymbols(rule.symbols);
  }

  void ResolveSymbols(ast::Range symbols) {
    for (std::uint32_t k = 0; k < symbols.count; ++k) {
      const std::uint32_t at = symbols.first + k;
      const ast::Symbol& symbol = file_.symbols[at];
      result_.symbols[at] = ResolveSymbol(symbol.name);
      for (std::uint32_t a = 0; a < symbol.arguments.count; ++a)
        ResolveArgument(symbol.arguments.first + a);
    }
  }

  void ResolveTest(const ast::Test& test) {
    ResolveSymbols(test.symbols);
    for (std::uint32_t k = 0; k < test.nodes.count; ++k) {
      const std::uint32_t at = test.nodes.first + k;
      const ast::BodyNode& node = file_.nodes[at];
      result_.nodes[at].symbol = ResolveSymbol(node.name);
      if (node.depth > 0) result_.nodes[at].face = ResolveFace(node.face);
    }
  }

  std::optional<Face> ResolveFace(Span name) {
    if (const auto face = ValueIn(kFaceNames, file_.Text(name))) return face;
    if (reporter_.is_full()) return std::nullopt;
    const std::vector<std::string_view> names = AllNames(kFaceNames);
    SuggestAmong(
        names,
        &reporter_
             .Report(Code::kImpossibleBody, name,
                     fmt::format("a module has no face '{}'", file_.Text(name)))
             .WithLabel(fmt::format("faces are {}", fmt::join(names, ", "))));
    return std::nullopt;
  }

  static constexpr auto kEqual = ast::Comparison::kEqual;
  static constexpr auto kNotEqual = ast::Comparison::kNotEqual;

  const State& StateOf(StateId id) const { return scope_.header.StateOf(id); }
  bool IsOrdered(StateId id) const {
    return StateOf(id).type == StateType::kReal;
  }

  std::optional<SymbolId> ResolveSymbol(Span name) {
    const AlphabetPtr& alphabet = scope_.header.alphabet;
    if (alphabet == nullptr) return std::nullopt;
    const std::string_view text = file_.Text(name);
    if (const auto id = alphabet->Find(text)) return id;
    if (reporter_.is_full()) return std::nullopt;
    Diagnostic& diagnostic =
        reporter_.Report(Code::kUnknownSymbol, name,
                         fmt::format("unknown symbol '{}' in alphabet '{}'",
                                     text, alphabet->name()));
    // Who writes as the authors' program does is told its name here, not the
    // one that happens to be spelt alike.
    const std::string_view foreign = alphabet->is_built_in()
                                         ? PlasticodingNameFor(text)
                                         : std::string_view();
    if (foreign.empty()) {
      SuggestAmong(NamesOf(alphabet->symbols(),
                           [](const SymbolInfo& symbol) {
                             return std::string_view(symbol.name);
                           }),
                   &diagnostic);
    } else {
      diagnostic.WithLabel(fmt::format("write '{}'", foreign))
          .WithNote(ForeignNote(text))
          .WithFix(name, std::string(foreign));
    }
    return std::nullopt;
  }

  const Constant* ResolveConstant(const ast::Value& value) {
    const std::string_view name = file_.Text(value.span);
    if (const Constant* constant = scope_.FindConstant(name)) return constant;
    if (reporter_.is_full()) return nullptr;
    if (IsNotFiniteWord(name)) {
      reporter_.Add(NotANumber(name, value.span));
    } else if (!file_.is_incomplete) {
      SuggestAmong(
          NamesOf(scope_.constants,
                  [](const Constant& constant) { return constant.name; }),
          &reporter_.Report(
              Code::kUnknownConstant, value.span,
              fmt::format("constant '{}' is not declared", name)));
    }
    return nullptr;
  }

  void ResolveArgument(std::uint32_t index) {
    const ast::Value& value = file_.arguments[index];
    ResolvedArgument& resolved = result_.arguments[index];
    if (value.kind == ast::Value::Kind::kNumber) {
      resolved = {value.number, value.is_integer, true};
    } else if (const Constant* constant = ResolveConstant(value)) {
      resolved = {constant->value, constant->is_integer, true};
    }
  }

  ResolvedTerm ResolveTerm(Span state, const ast::Value& value) {
    const std::string_view name = file_.Text(state);
    const auto id = scope_.FindState(name);
    if (!id) {
      ReportUnknownState(state);
      return std::nullopt;
    }
    Term term;
    term.state = *id;
    const auto number = ResolveValue(*id, value);
    if (!number) return std::nullopt;
    term.value = *number;
    return term;
  }

  void ReportUnknownState(Span state) {
    // The item that declares it may be the one that did not parse.
    if (file_.is_incomplete || reporter_.is_full()) return;
    Diagnostic& diagnostic = reporter_.Report(
        Code::kUnknownState, state,
        fmt::format("state '{}' is not declared", file_.Text(state)));
    const std::vector<State>& states = scope_.header.states;
    SuggestAmong(
        NamesOf(states,
                [](const State& s) { return std::string_view(s.name); }),
        &diagnostic);
    if (diagnostic.fixes.empty()) {
      diagnostic.help =
          fmt::format("declare it, as in 'sense {}: bool'", file_.Text(state));
      return;
    }
    const auto known = scope_.FindState(diagnostic.fixes[0].replacement);
    diagnostic.WithOther(scope_.state_spans[static_cast<std::size_t>(*known)],
                         "declared here");
  }

  std::optional<double> ResolveValue(StateId id, const ast::Value& value) {
    const State& state = StateOf(id);
    using Kind = ast::Value::Kind;
    switch (state.type) {
      case StateType::kBool:
        if (value.kind == Kind::kTrue) return 1;
        if (value.kind == Kind::kFalse) return 0;
        break;
      case StateType::kReal:
        if (value.kind == Kind::kNumber) return value.number;
        if (value.kind == Kind::kName) {
          const Constant* constant = ResolveConstant(value);
          if (constant == nullptr) return std::nullopt;
          return constant->value;
        }
        break;
      case StateType::kEnum:
        if (value.kind == Kind::kName) return EnumIndex(id, value);
        break;
    }
    ReportMismatch(state, value);
    return std::nullopt;
  }

  std::optional<double> EnumIndex(StateId id, const ast::Value& value) {
    const State& state = StateOf(id);
    const std::string_view text = file_.Text(value.span);
    if (const auto index = scope_.FindValue(id, text))
      return static_cast<double>(*index);
    if (reporter_.is_full()) return std::nullopt;
    SuggestAmong(
        NamesOf(state.values,
                [](const std::string& v) { return std::string_view(v); }),
        &reporter_
             .Report(
                 Code::kValueType, value.span,
                 fmt::format("state '{}' has no value '{}'", state.name, text))
             .WithLabel(fmt::format("it is one of {}",
                                    fmt::join(state.values, ", "))));
    return std::nullopt;
  }

  void ReportMismatch(const State& state, const ast::Value& value) {
    if (reporter_.is_full()) return;
    const std::string_view text = file_.Text(value.span);
    std::string message;
    std::string label;
    if (state.type == StateType::kBool) {
      message = fmt::format("'{}' is a bool state and cannot be {}", state.name,
                            text);
      label = "use True or False";
    } else if (state.type == StateType::kReal) {
      message = fmt::format(
          "'{}' is a real state and cannot be compared with "
          "{}",
          state.name, text);
      label = fmt::format("compare with a number, as in '{} > {}'", state.name,
                          PrintNumber((state.low + state.high) / 2));
    } else {
      message = fmt::format("'{}' cannot be {}", state.name, text);
      label = fmt::format("it is one of {}", fmt::join(state.values, ", "));
    }
    const auto id = scope_.FindState(state.name);
    reporter_.Report(Code::kValueType, value.span, std::move(message))
        .WithLabel(std::move(label))
        .WithOther(scope_.state_spans[static_cast<std::size_t>(*id)],
                   "declared here");
  }

  const ast::File& file_;
  const Scope& scope_;
  Resolution result_;
  // Asked for room first: what finds none costs no search for similar names.
  Reporter reporter_;
};

}  // namespace

Resolution Resolve(const ast::File& file, const Scope& scope) {
  return Resolver(file, scope).Resolve();
}

}  // namespace plsc
