// What does nothing anywhere can only be said of all environments, so the
// genotype is developed once a regime, and each symbol of each rule collects
// what it came to there: expressed in some, read in some, never read. A warning
// is about what no regime expressed.
//
// Expressed has two senses. A symbol that is rewritten is a call and does its
// work there; which symbols ever stand in a string that is rewritten is found
// by following each symbol once (rewriting is free of context), not by looking
// through strings. A symbol of the final string is expressed if its turtle did
// something with it, which the trace says.
//
// Rules of C are read once a rewriting, from the core if the reading before did
// not leave it (WatchReadings, by the lengths that growth gives); a symbol that
// one reading expresses and a later one cannot is in its own way.
//
// The strings of all regimes together are bounded by kMaxLintedSymbols, counted
// before they are derived.

#include "runtime/advice/lint_expression.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "compiler/limits.h"
#include "grammar/reporter.h"
#include "runtime/develop/derive.h"
#include "runtime/develop/growth.h"
#include "runtime/develop/trace.h"

namespace plsc {

namespace {

// What one symbol of a production came to, over all regimes.
struct Fate {
  bool is_expressed = false;
  bool is_read = false;  // late development read it
  Effect last{};         // why it was not expressed there
  // A controller command that was expressed right behind a joint that was not
  // mounted, and so on another joint: why that was not.
  std::optional<Effect> missing_joint;
};

struct RuleFate {
  bool is_active = false;  // in some regime
  bool is_used = false;    // and rewrote something there
  std::vector<Fate> symbols;
  // Of a rule of C: a symbol that one reading expresses and a later one, which
  // begins on the core again, does not.
  std::optional<std::uint32_t> repeated;
};

class Watcher {
 public:
  explicit Watcher(const Genotype& genotype) : genotype_(genotype) {
    fates_.resize(genotype.rules.size());
    for (std::size_t i = 0; i < fates_.size(); ++i)
      fates_[i].symbols.resize(genotype.rules[i].production.size());
  }

  void Watch(const ActiveRules& active) {
    for (const RuleIndex rule : active.rules) fates_[rule].is_active = true;
    WatchRewriting(active);
    const auto string = Derive(genotype_, active);
    assert(string);
    if (genotype_.alphabet->is_built_in())
      WatchDevelopment(*string, active);
    else
      for (const Occurrence& occurrence : *string) Express(occurrence);
  }

  const std::vector<RuleFate>& fates() const { return fates_; }

 private:
  Fate* FateOf(const Occurrence& occurrence) {
    if (occurrence.rule == kNoRule) return nullptr;
    return &fates_[occurrence.rule].symbols[occurrence.position];
  }
  void Express(const Occurrence& occurrence) {
    if (Fate* fate = FateOf(occurrence)) fate->is_expressed = true;
  }

  // Rewriting is free of context: which symbols ever stand in a string before
  // its last rewriting is found by following each symbol once.
  void WatchRewriting(const ActiveRules& active) {
    const int iterations = genotype_.development.iterations;
    std::vector<bool> is_rewritten(active.joined.size(), false);
    std::vector<bool> is_seen = is_rewritten;
    std::vector<SymbolId> front = {genotype_.axiom};
    is_seen[static_cast<std::size_t>(genotype_.axiom)] = true;
    for (int i = 0; i < iterations && !front.empty(); ++i) {
      std::vector<SymbolId> next;
      for (const SymbolId symbol : front) {
        is_rewritten[static_cast<std::size_t>(symbol)] = true;
        for (const Occurrence& made : active.joined[symbol]) {
          const auto index = static_cast<std::size_t>(made.symbol);
          // In a string that is rewritten once more, this is a call.
          if (i + 1 < iterations && !active.joined[made.symbol].empty())
            Express(made);
          if (is_seen[index]) continue;
          is_seen[index] = true;
          next.push_back(made.symbol);
        }
      }
      front = std::move(next);
    }
    for (const RuleIndex rule : active.rules)
      if (is_rewritten[static_cast<std::size_t>(genotype_.rules[rule].head)])
        fates_[rule].is_used = true;
  }

  void WatchDevelopment(const SymbolString& string, const ActiveRules& active) {
    const Trace trace = TraceDevelopment(genotype_, string);
    WatchJoints(string, trace);
    WatchReadings(string, trace, active);
    for (std::size_t i = 0; i < string.size(); ++i) {
      Fate* fate = FateOf(string[i]);
      if (fate == nullptr) continue;
      const Effect effect = trace.events[i].effect;
      fate->is_expressed |= InfoOf(effect).is_expressed;
      fate->is_read = true;
      fate->last = effect;
    }
  }

  // Commands right behind a joint are meant for it.
  void WatchJoints(const SymbolString& string, const Trace& trace) {
    std::optional<Effect> missing;
    for (std::size_t i = 0; i < string.size(); ++i) {
      const SymbolId symbol = string[i].symbol;
      const Effect effect = trace.events[i].effect;
      if (symbol == plasticoding::kA1 || symbol == plasticoding::kA2) {
        missing.reset();
        if (effect != Effect::kMounted) missing = effect;
      } else if (genotype_.SymbolOf(symbol).category !=
                 Category::kControllerChanging) {
        missing.reset();
      } else if (missing && InfoOf(effect).is_expressed) {
        if (Fate* fate = FateOf(string[i])) fate->missing_joint = missing;
      }
    }
  }

  // The string is C and, for each rewriting, the rest of its production: the
  // newest first, older ones rewritten since.
  void WatchReadings(const SymbolString& string, const Trace& trace,
                     const ActiveRules& active) {
    std::vector<std::vector<bool>> expressed(fates_.size());
    for (std::size_t i = 0; i < fates_.size(); ++i)
      if (genotype_.rules[i].head == plasticoding::kC)
        expressed[i].resize(genotype_.rules[i].production.size());
    std::size_t begin = 1;
    for (const std::uint64_t length : ReadingLengths(genotype_, active)) {
      const std::size_t end = begin + static_cast<std::size_t>(length);
      // The first one always does.
      const bool is_again =
          begin > 1 && begin < end && trace.events[begin].reference == 0;
      for (std::size_t i = begin; i < end; ++i) {
        const Occurrence& occurrence = string[i];
        if (occurrence.rule == kNoRule || expressed[occurrence.rule].empty())
          continue;
        const bool is_expressed = InfoOf(trace.events[i].effect).is_expressed;
        auto seen = expressed[occurrence.rule].begin() +
                    static_cast<std::ptrdiff_t>(occurrence.position);
        if (is_again && *seen && !is_expressed)
          fates_[occurrence.rule].repeated = occurrence.position;
        *seen = *seen || is_expressed;
      }
      begin = end;
    }
  }

  const Genotype& genotype_;
  std::vector<RuleFate> fates_;
};

Diagnostic OfMissingJoint(Span span, SymbolId command, Effect why,
                          const Alphabet& alphabet) {
  return Diagnostic(
             Code::kOtherJoint, span,
             fmt::format("somewhere this '{}' changes another joint than the "
                         "one before it",
                         alphabet[command].name))
      .WithLabel(fmt::format("that joint is not expressed there: {}",
                             InfoOf(why).text))
      .WithHelp(
          "commands change the newest joint that is mounted; 'plsc develop "
          "--trace' shows which");
}

Diagnostic OfRepeated(const RuleSpans& spans, std::uint32_t symbol,
                      int iterations) {
  return Diagnostic(
             Code::kReadAgain, spans.head,
             fmt::format("with 'iterations {}' this rule of C is read {} "
                         "times, again and again from the core",
                         iterations, iterations))
      .WithLabel("the first reading is in the way of the others")
      .WithOther(spans.symbols[symbol],
                 "expressed in one reading, not in a later one")
      .WithHelp(
          "write 'iterations 1', or end the rule with a move to where the next "
          "reading shall go on");
}

void ReportSymbols(const Rule& rule, const RuleFate& fate,
                   const RuleSpans& spans, const Genotype& genotype,
                   Reporter* reporter) {
  const bool is_core_rule =
      genotype.alphabet->is_built_in() && rule.head == plasticoding::kC;
  for (std::size_t i = 0; i < fate.symbols.size(); ++i) {
    if (!reporter->Takes(Severity::kWarning)) return;
    const Fate& symbol = fate.symbols[i];
    if (symbol.missing_joint)
      reporter->Add(OfMissingJoint(spans.symbols[i], rule.production[i].id,
                                   *symbol.missing_joint, *genotype.alphabet));
    // The C that begins each rule of C is a matter of form.
    if (symbol.is_expressed || !symbol.is_read || (is_core_rule && i == 0))
      continue;
    reporter
        ->Report(Code::kNotExpressed, spans.symbols[i],
                 fmt::format("this '{}' is expressed in no environment",
                             genotype.SymbolOf(rule.production[i].id).name))
        .WithLabel(std::string(InfoOf(symbol.last).text));
  }
}

std::vector<Diagnostic> ReportAll(const MappedProgram& compiled,
                                  const std::vector<RuleFate>& fates) {
  const Genotype& genotype = compiled.program.genotype;
  Reporter reporter;
  for (std::size_t i = 0; i < fates.size(); ++i) {
    if (!reporter.Takes(Severity::kWarning)) break;
    const RuleSpans& spans = compiled.map.rules[i];
    if (fates[i].repeated)
      reporter.Add(OfRepeated(spans, *fates[i].repeated,
                              genotype.development.iterations));
    if (fates[i].is_used) {
      ReportSymbols(genotype.rules[i], fates[i], spans, genotype, &reporter);
    } else if (fates[i].is_active) {  // never active is W3002's to say
      const std::string& head = genotype.SymbolOf(genotype.rules[i].head).name;
      reporter
          .Report(Code::kNotExpressed, spans.head,
                  fmt::format("this rule for '{}' rewrites nothing", head))
          .WithLabel(fmt::format(
              "where it is active, no '{}' stands in a string that is "
              "rewritten",
              head));
    }
  }
  return reporter.Take();
}

}  // namespace

std::vector<Diagnostic> LintExpression(const MappedProgram& compiled,
                                       const StateSpace& space,
                                       const std::vector<Regime>& regimes,
                                       Span file) {
  const Genotype& genotype = compiled.program.genotype;
  Watcher watcher(genotype);
  std::uint64_t developed = 0;
  for (const Regime& regime : regimes) {
    const ActiveRules active =
        Regulate(genotype, {space.At(regime.environment)});
    developed += DerivedLength(genotype, active);
    if (developed > kMaxLintedSymbols)
      return {
          Diagnostic(
              Code::kUnchecked, file,
              fmt::format("developing in every environment would take more "
                          "than {} symbols",
                          kMaxLintedSymbols))
              .WithLabel("whether every symbol is expressed is not checked")};
    watcher.Watch(active);
  }
  return ReportAll(compiled, watcher.fates());
}

}  // namespace plsc
