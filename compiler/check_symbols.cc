#include "compiler/check_symbols.h"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>

#include "compiler/limits.h"
#include "grammar/number.h"

namespace plsc {

namespace {

std::string RangeText(const Parameter& parameter) {
  if (std::isinf(parameter.low) && std::isinf(parameter.high)) return "";
  if (std::isinf(parameter.high))
    return fmt::format("{} or more", PrintNumber(parameter.low));
  return fmt::format("{}..{}", PrintNumber(parameter.low),
                     PrintNumber(parameter.high));
}

std::string NamesOf(const SymbolInfo& symbol) {
  std::string names;
  for (const Parameter& parameter : symbol.parameters)
    names += (names.empty() ? "" : ", ") + parameter.name;
  return names;
}

class SymbolChecker {
 public:
  SymbolChecker(const ast::File& file, const Scope& scope,
                const Resolution& resolution, const CompileOptions& options,
                Reporter* reporter)
      : file_(file),
        alphabet_(*scope.header.alphabet),
        resolution_(resolution),
        options_(options),
        reporter_(*reporter) {}

  void Check() {
    for (std::size_t i = 0; i < file_.rules.size() && !reporter_.is_full();
         ++i) {
      const ast::Rule& rule = file_.rules[i];
      CheckHead(rule, resolution_.heads[i]);
      for (std::uint32_t k = 0; k < rule.symbols.count && !reporter_.is_full();
           ++k) {
        const auto id = resolution_.symbols[rule.symbols.first + k];
        if (id) CheckArguments(file_.symbols[rule.symbols.first + k], *id);
      }
      if (alphabet_.is_built_in()) CheckCore(rule, resolution_.heads[i]);
    }
    for (const ast::Test& test : file_.tests) {
      for (std::uint32_t k = 0; k < test.symbols.count && !reporter_.is_full();
           ++k) {
        const ast::Symbol& symbol = file_.symbols[test.symbols.first + k];
        const auto id = resolution_.symbols[test.symbols.first + k];
        // Arguments that are left out will be whatever they are.
        if (id && symbol.has_parens) CheckArguments(symbol, *id);
      }
    }
  }

 private:
  void CheckHead(const ast::Rule& rule, std::optional<SymbolId> head) {
    if (!head || alphabet_[*head].is_replaceable) return;
    std::vector<std::string> replaceable;
    for (const SymbolInfo& symbol : alphabet_.symbols())
      if (symbol.is_replaceable) replaceable.push_back(symbol.name);
    reporter_
        .Report(Code::kNotReplaceable, rule.head,
                fmt::format("'{}' is a {} and cannot have a rule",
                            file_.Text(rule.head),
                            alphabet_.is_built_in() ? "command" : "terminal"))
        .WithLabel(replaceable.empty()
                       ? "no symbol of this alphabet is replaceable"
                       : fmt::format("replaceable symbols are {}",
                                     fmt::join(replaceable, ", ")));
  }

  void CheckArguments(const ast::Symbol& symbol, SymbolId id) {
    const SymbolInfo& info = alphabet_[id];
    if (symbol.arguments.count != info.parameters.size()) {
      ReportCount(symbol, info);
      return;
    }
    for (std::uint32_t k = 0; k < symbol.arguments.count; ++k) {
      const std::uint32_t at = symbol.arguments.first + k;
      const ResolvedArgument& argument = resolution_.arguments[at];
      if (argument.is_known)
        CheckArgument(info, info.parameters[k], file_.arguments[at].span,
                      argument);
    }
  }

  void ReportCount(const ast::Symbol& symbol, const SymbolInfo& info) {
    const std::size_t wanted = info.parameters.size();
    const std::size_t given = symbol.arguments.count;
    const std::string takes =
        wanted == 0 ? "no parameters"
                    : fmt::format("{} parameter{} ({})", wanted,
                                  wanted == 1 ? "" : "s", NamesOf(info));
    Diagnostic& diagnostic = reporter_.Report(
        Code::kArgumentCount, symbol.span,
        fmt::format("{} takes {}, {} given", info.name, takes, given));
    if (given < wanted) {
      const Parameter& missing = info.parameters[given];
      diagnostic.label = fmt::format("missing '{}'", missing.name);
      if (!missing.doc.empty())
        diagnostic.label += fmt::format(" ({})", missing.doc);
    } else if (wanted == 0) {
      diagnostic.WithFix({symbol.name.end, symbol.span.end}, "");
    }
  }

  void CheckArgument(const SymbolInfo& info, const Parameter& parameter,
                     Span span, const ResolvedArgument& argument) {
    const bool is_whole =
        argument.is_integer && std::abs(argument.value) <= kMaxWholeNumber;
    if (parameter.is_integer && !is_whole) {
      reporter_
          .Report(Code::kNotWhole, span,
                  fmt::format("parameter '{}' of {} must be a whole number",
                              parameter.name, info.name))
          .WithLabel("written without '.' and exponent, as in '2'");
      return;
    }
    if (argument.value >= parameter.low && argument.value <= parameter.high)
      return;
    Diagnostic diagnostic(
        Code::kArgumentRange, span,
        fmt::format("parameter '{}' of {} is {}, expected {}", parameter.name,
                    info.name, file_.Text(span), RangeText(parameter)));
    diagnostic.label = Signature(info);
    if (options_.allow_out_of_range)
      diagnostic.severity = Severity::kWarning;
    else
      diagnostic.help = "'--allow-range' makes this a warning";
    reporter_.Add(std::move(diagnostic));
  }

  // A robot has exactly one core: every production of C starts with it, and
  // it occurs nowhere else.
  void CheckCore(const ast::Rule& rule, std::optional<SymbolId> head) {
    const bool is_core_rule = head == plasticoding::kC;
    for (std::uint32_t k = 0; k < rule.symbols.count && !reporter_.is_full();
         ++k) {
      const std::uint32_t at = rule.symbols.first + k;
      const auto id = resolution_.symbols[at];
      const bool is_core = id == plasticoding::kC;
      const Span span = file_.symbols[at].span;
      if (is_core && (!is_core_rule || k > 0)) {
        reporter_
            .Report(
                Code::kMisplacedCore, span,
                "the core C may appear only as the first symbol of a rule for "
                "C")
            .WithLabel("a robot has exactly one core");
      } else if (is_core_rule && k == 0 && !is_core && id) {
        reporter_
            .Report(Code::kMisplacedCore, span,
                    fmt::format("a rule for C must start with C, not with '{}'",
                                file_.Text(file_.symbols[at].name)))
            .WithLabel("the robot would lose its core")
            .WithFix({span.begin, span.begin}, "C ");
      }
    }
  }

  const ast::File& file_;
  const Alphabet& alphabet_;
  const Resolution& resolution_;
  const CompileOptions& options_;
  Reporter& reporter_;
};

}  // namespace

std::string Signature(const SymbolInfo& symbol) {
  std::string text;
  for (const Parameter& parameter : symbol.parameters) {
    if (!text.empty()) text += ", ";
    text += parameter.name;
    const std::string range = RangeText(parameter);
    if (!range.empty()) text += " in " + range;
  }
  return text.empty() ? symbol.name : fmt::format("{}({})", symbol.name, text);
}

void CheckSymbols(const ast::File& file, const Scope& scope,
                  const Resolution& resolution, const CompileOptions& options,
                  Reporter* reporter) {
  SymbolChecker(file, scope, resolution, options, reporter).Check();
}

}  // namespace plsc
