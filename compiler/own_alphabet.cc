#include "compiler/own_alphabet.h"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <unordered_map>
#include <utility>

#include "compiler/limits.h"
#include "grammar/reporter.h"

namespace plsc {

namespace {

class AlphabetDeclarer {
 public:
  explicit AlphabetDeclarer(const ast::File& file) : file_(file) {}

  OwnAlphabet Declare(const ast::Alphabet& declared) {
    std::vector<SymbolInfo> symbols;
    for (const ast::Declaration& symbol :
         ast::Slice(file_.declarations, declared.declarations)) {
      if (reporter_.is_full()) break;
      if (symbols.size() == kMaxSymbols) {
        reporter_.Report(
            Code::kLimit, symbol.name,
            fmt::format("an alphabet has at most {} symbols", kMaxSymbols));
        break;
      }
      if (IsNew(symbol.name, "symbol", &symbol_spans_))
        symbols.push_back(DeclareSymbol(symbol));
    }
    return {std::make_shared<const Alphabet>(
                std::string(file_.Text(declared.name)), 0, std::move(symbols)),
            reporter_.Take()};
  }

 private:
  using Spans = std::unordered_map<std::string_view, Span>;

  bool IsNew(Span name, const char* what, Spans* known) {
    const auto [first, is_new] = known->emplace(file_.Text(name), name);
    if (is_new) return true;
    reporter_
        .Report(
            Code::kRepeatedName, name,
            fmt::format("{} '{}' is declared twice", what, file_.Text(name)))
        .WithOther(first->second, "first declared here");
    return false;
  }

  SymbolInfo DeclareSymbol(const ast::Declaration& declared) {
    SymbolInfo symbol;
    symbol.name = file_.Text(declared.name);
    symbol.is_replaceable = declared.is_replaceable;
    symbol.category =
        declared.is_replaceable ? Category::kModule : Category::kTerminal;
    Spans names;
    const auto parameters = ast::Slice(file_.parameters, declared.parameters);
    if (parameters.size() > kMaxParameters) {
      reporter_.Report(
          Code::kWrongParameters, parameters[kMaxParameters].name,
          fmt::format("a symbol has at most {} parameters, '{}' has {}",
                      kMaxParameters, symbol.name, parameters.size()));
      return symbol;
    }
    for (const ast::Parameter& parameter : parameters)
      if (IsNew(parameter.name, "parameter", &names))
        symbol.parameters.push_back(DeclareParameter(parameter));
    return symbol;
  }

  Parameter DeclareParameter(const ast::Parameter& declared) {
    Parameter parameter;
    parameter.name = file_.Text(declared.name);
    parameter.is_integer = declared.is_integer;
    if (declared.bounds.is_present) {
      parameter.low = declared.bounds.low.number;
      parameter.high = declared.bounds.high.number;
      CheckBounds(declared);
    }
    parameter.sampling = DefaultSampling(parameter);
    return parameter;
  }

  void CheckBounds(const ast::Parameter& declared) {
    const ast::Value& low = declared.bounds.low;
    const ast::Value& high = declared.bounds.high;
    for (const ast::Value* bound : {&low, &high}) {
      const bool is_whole =
          bound->is_integer && std::abs(bound->number) <= kMaxWholeNumber;
      if (declared.is_integer && !is_whole)
        reporter_.Report(
            Code::kWrongParameters, bound->span,
            fmt::format("expected a whole number up to 2^53 as a bound of "
                        "'{}', which is int",
                        file_.Text(declared.name)));
    }
    if (low.number > high.number)
      reporter_.Report(
          Code::kWrongParameters, {low.span.begin, high.span.end},
          fmt::format("the range of '{}' is empty: {} is more than {}",
                      file_.Text(declared.name), file_.Text(low.span),
                      file_.Text(high.span)));
  }

  const ast::File& file_;
  Spans symbol_spans_;
  Reporter reporter_;
};

}  // namespace

OwnAlphabet DeclareAlphabet(const ast::File& file,
                            const ast::Alphabet& declared) {
  return AlphabetDeclarer(file).Declare(declared);
}

Sampling DefaultSampling(const Parameter& parameter) {
  if (std::isfinite(parameter.low)) return Sampling::kUniform;
  return parameter.is_integer ? Sampling::kCeilAbsNormal : Sampling::kNormal;
}

}  // namespace plsc
