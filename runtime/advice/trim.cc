// Which parts of a genotype do nothing is not read off it: a symbol that is
// never expressed may still hold the place of one that is, and a rule that is
// never active may become it when another clause changes. So it is tried, in
// the manner of delta debugging (Zeller and Hildebrandt 2002): leave a window
// of pieces out, develop in every environment, and keep it out if all robots
// are the same bit for bit. Windows begin with everything of a kind and are
// halved, from the back of the text, since what comes later in a string depends
// on what comes before. Pairs follow, because a move and the move back do
// something each and nothing together.
//
// What holds after each try: `kept_` and `targets_` belong together, and every
// target develops as the text did that was given. So it may end at any time,
// and does when max_work symbols have been derived. If it ends by itself, a
// whole round changed nothing, and trimming the result again changes nothing.
//
// The proof at the end starts from the text that is handed out, compiled anew,
// not from the genotypes that were tried: text and genotype were cut by
// different code, and a mistake in either must not get out.
//
// Tries times regimes times the length of strings: some 10^5 symbols for a
// random genotype of the paper's kind.

#include "runtime/advice/trim.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "runtime/advice/trim_pieces.h"
#include "runtime/advice/trim_target.h"
#include "runtime/advice/trim_text.h"
#include "runtime/develop/trace.h"

namespace plsc {

namespace {

class Trimmer {
 public:
  Trimmer(std::span<const MappedProgram> programs, const TrimOptions& options)
      : programs_(programs),
        pieces_(PiecesOf(programs)),
        kept_(pieces_.all.size(), true),
        work_left_(options.max_work),
        only_(options.only),
        lived_(options.lived) {}

  /// What keeps the genotypes from being developed everywhere.
  std::vector<Diagnostic> Prepare() {
    std::vector<Diagnostic> problems;
    for (std::size_t p = 0; p < programs_.size(); ++p) {
      LivedEnvironments lived;
      if (!lived_.empty()) lived = lived_[p];
      Result<TrimTarget> target =
          MakeTrimTarget(programs_[p], std::move(lived));
      if (target)
        targets_.push_back(std::move(*target));
      else
        problems.push_back(target.diagnostics().front());
    }
    return problems;
  }

  void Run() {
    Kept before;
    do {
      before = kept_;
      TryRules();
      TryClauses();
      TrySymbols();
    } while (kept_ != before && work_left_ > 0);
  }

  const Pieces& pieces() const { return pieces_; }
  const Kept& kept() const { return kept_; }
  bool is_complete() const { return work_left_ > 0; }
  const Genotype& genotype(std::size_t program) const {
    return targets_[program].current;
  }

 private:
  // Whether the pieces are gone: no robot changes without them. A piece may
  // belong to several genotypes; then it goes from all of them or from none, so
  // the targets are exchanged only when every one has agreed.
  bool Try(const std::vector<std::size_t>& out) {
    if (work_left_ == 0 || out.empty()) return false;
    std::vector<std::size_t> affected;
    // Pieces of one kind are tried together.
    const PieceKind kind = pieces_.all[out.front()].kind;
    for (const std::size_t piece : out) {
      kept_[piece] = false;
      for (const std::size_t program : pieces_.all[piece].programs)
        affected.push_back(program);
    }
    std::sort(affected.begin(), affected.end());
    affected.erase(std::unique(affected.begin(), affected.end()),
                   affected.end());
    std::vector<TrimTarget> changed;
    for (const std::size_t program : affected) {
      auto next = Changed(program, kind);
      if (!next) {
        for (const std::size_t piece : out) kept_[piece] = true;
        return false;
      }
      changed.push_back(std::move(*next));
    }
    for (std::size_t i = 0; i < affected.size(); ++i)
      targets_[affected[i]] = std::move(changed[i]);
    return true;
  }

  void Work(std::uint64_t symbols) {
    work_left_ -= std::min(work_left_, symbols);
  }

  // The target with what is kept now; nothing if a robot would be another.
  std::optional<TrimTarget> Changed(std::size_t program, PieceKind kind) {
    const TrimTarget& target = targets_[program];
    // An eighth: a symbol is copied faster than derived.
    Work(1 + pieces_.of[program].size() + pieces_.all.size() / 8);
    auto genotype =
        KeepPieces(target.mapped->program.genotype, pieces_.of[program], kept_);
    if (!genotype) return std::nullopt;
    TrimTry attempt = TryGenotype(target, std::move(*genotype), kind);
    Work(attempt.work);
    return std::move(attempt.target);
  }

  bool MayTouch(const Piece& piece) const {
    return !only_ || std::find(piece.programs.begin(), piece.programs.end(),
                               *only_) != piece.programs.end();
  }

  // Windows of all sizes, halved each time, from the back: what comes later in
  // a string depends on what comes before. Then pairs at every place, as a
  // move and the move back change something alone, but nothing together.
  void TryChunks(std::vector<std::size_t> present) {
    for (std::size_t size = present.size(); size > 0; size /= 2)
      present = TryWindows(std::move(present), size, size);
    TryWindows(std::move(present), 2, 1);
  }

  // The pieces that stay.
  std::vector<std::size_t> TryWindows(std::vector<std::size_t> present,
                                      std::size_t size, std::size_t step) {
    std::size_t end = present.size();
    while (end > 0) {
      const std::size_t begin = end - std::min(size, end);
      const std::vector<std::size_t> window(
          present.begin() + static_cast<std::ptrdiff_t>(begin),
          present.begin() + static_cast<std::ptrdiff_t>(end));
      if (Try(window)) {
        present.erase(present.begin() + static_cast<std::ptrdiff_t>(begin),
                      present.begin() + static_cast<std::ptrdiff_t>(end));
        // Windows that reach over the gap have pieces together that were not
        // neighbours before: they are tried again.
        end = std::min(begin + (size - step), present.size());
        if (begin == 0) end = 0;
      } else {
        end -= std::min(step, end);
      }
    }
    return present;
  }

  // Those of a kind that are in the text, in its order.
  std::vector<std::size_t> Present(PieceKind kind) const {
    std::vector<bool> is_seen(pieces_.all.size(), false);
    std::vector<std::size_t> present;
    const auto add = [&](std::size_t piece) {
      const Piece& one = pieces_.all[piece];
      if (one.kind != kind || is_seen[piece] || !kept_[piece] || !MayTouch(one))
        return;
      is_seen[piece] = true;
      present.push_back(piece);
    };
    for (const auto& rules : pieces_.of)
      for (const RulePieces& rule : rules) {
        if (!kept_[rule.rule]) continue;
        add(rule.rule);
        for (const std::size_t term : rule.terms) add(term);
        for (const std::size_t symbol : rule.symbols) add(symbol);
      }
    std::sort(present.begin(), present.end(), [&](auto a, auto b) {
      return pieces_.all[a].span.begin < pieces_.all[b].span.begin;
    });
    return present;
  }

  void TryRules() { TryChunks(Present(PieceKind::kRule)); }

  // All terms of a clause, then runs of them: an `and` group is one.
  void TryClauses() {
    const std::vector<std::size_t> present = Present(PieceKind::kTerm);
    std::vector<bool> is_present(pieces_.all.size(), false);
    for (const std::size_t piece : present) is_present[piece] = true;
    for (const auto& rules : pieces_.of)
      for (const RulePieces& rule : rules) {
        std::vector<std::size_t> terms;
        for (const std::size_t term : rule.terms)
          if (kept_[rule.rule] && kept_[term] && is_present[term])
            terms.push_back(term);
        for (std::size_t size = terms.size(); size > 0; --size)
          terms = TryWindows(std::move(terms), size, 1);
      }
  }

  // First all at once that development never expressed: nearly always right,
  // and it spares most of the windows. Where it is not, the windows find out.
  void TrySymbols() {
    std::vector<std::size_t> idle = IdleSymbols();
    Try(idle);
    TryChunks(Present(PieceKind::kSymbol));
  }

  std::vector<std::size_t> IdleSymbols() {
    std::vector<bool> is_used(pieces_.all.size(), false);
    for (std::size_t p = 0; p < targets_.size(); ++p) MarkUsed(p, &is_used);
    std::vector<std::size_t> idle;
    for (const std::size_t piece : Present(PieceKind::kSymbol))
      if (!is_used[piece]) idle.push_back(piece);
    return idle;
  }

  // The pieces of the symbols of `current`, by rule: its rules and symbols are
  // those that are kept, in the same order.
  std::vector<std::vector<std::size_t>> CurrentSymbols(std::size_t p) const {
    std::vector<std::vector<std::size_t>> symbols;
    for (const RulePieces& rule : pieces_.of[p]) {
      if (!kept_[rule.rule]) continue;
      symbols.emplace_back();
      for (const std::size_t symbol : rule.symbols)
        if (kept_[symbol]) symbols.back().push_back(symbol);
    }
    return symbols;
  }

  void MarkUsed(std::size_t p, std::vector<bool>* is_used) {
    const TrimTarget& target = targets_[p];
    const Genotype& genotype = target.current;
    const auto pieces = CurrentSymbols(p);
    // A replaceable symbol may be a call; the first of C's rules is the core.
    for (std::size_t r = 0; r < genotype.rules.size(); ++r)
      for (std::size_t s = 0; s < pieces[r].size(); ++s)
        if (genotype.SymbolOf(genotype.rules[r].production[s].id)
                .is_replaceable)
          (*is_used)[pieces[r][s]] = true;
    for (const Regime& regime : target.regimes) {
      const ActiveRules active =
          Regulate(genotype, {target.space.At(regime.environment)});
      const SymbolString string = *Derive(genotype, active);
      Work(string.size());
      if (!genotype.alphabet->is_built_in()) {
        for (const Occurrence& o : string)
          if (o.rule != kNoRule) (*is_used)[pieces[o.rule][o.position]] = true;
        continue;
      }
      const Trace trace = TraceDevelopment(genotype, string);
      for (std::size_t i = 0; i < string.size(); ++i)
        if (string[i].rule != kNoRule &&
            InfoOf(trace.events[i].effect).is_expressed)
          (*is_used)[pieces[string[i].rule][string[i].position]] = true;
    }
  }

  std::span<const MappedProgram> programs_;
  Pieces pieces_;
  Kept kept_;
  std::uint64_t work_left_;
  std::optional<std::size_t> only_;
  std::vector<std::vector<NamedEnvironment>> lived_;
  std::vector<TrimTarget> targets_;
};

PieceCounts CountPieces(const Genotype& genotype) {
  PieceCounts counts;
  counts.rules = genotype.rules.size();
  for (const Rule& rule : genotype.rules) {
    counts.terms += rule.clause.terms.size();
    counts.symbols += rule.production.size();
  }
  return counts;
}

}  // namespace

Result<Trimmed> Trim(const Source& source, const TrimOptions& options) {
  const auto compiled = CompileAllWithMap(source, options.compile);
  if (!compiled) return compiled.diagnostics();
  assert(options.lived.empty() || options.lived.size() == compiled->size());
  Trimmer trimmer(*compiled, options);
  auto problems = trimmer.Prepare();
  if (!problems.empty()) return problems;
  trimmer.Run();
  Trimmed trimmed;
  trimmed.is_complete = trimmer.is_complete();
  trimmed.text = KeepText(source, *compiled, trimmer.pieces(), trimmer.kept());
  // The proof looks at the text that is handed out, not at what it was meant
  // to be.
  const auto after =
      CompileAll(Source(source.name(), trimmed.text), options.compile);
  assert(after && after->size() == compiled->size());
  for (std::size_t p = 0; p < after->size(); ++p) {
    const Program& before = (*compiled)[p].program;
    const Genotype& genotype = (*after)[p].genotype;
    assert(genotype == trimmer.genotype(p));
    auto proof = options.lived.empty()
                     ? CompareRegimes(before.genotype, genotype,
                                      before.environments, Compared::kAll)
                     : CompareRegimes(before.genotype, genotype,
                                      options.lived[p], Compared::kNamed);
    assert(proof && AreSame(*proof));
    trimmed.genotypes.push_back({genotype.name, CountPieces(before.genotype),
                                 CountPieces(genotype), std::move(*proof)});
  }
  return {std::move(trimmed), compiled.diagnostics()};
}

}  // namespace plsc
