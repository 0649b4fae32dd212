// Pieces are places of the text, not of a genotype: a rule that several
// genotypes share is one piece with several programs. KeepPieces makes of a
// genotype what the text would compile to without the pieces that went, so that
// tries need no compiler; Trim proves at the end that it does.
//
// Which connective stays between two terms of which those between went? If one
// of those that joined them was an `or`, they were in different groups and stay
// so (JoiningConnective): `a and b or c` without b is `a or c`.

#include "runtime/advice/trim_pieces.h"

#include <algorithm>
#include <map>
#include <utility>

namespace plsc {

namespace {

// Pieces by where they stand: of no kind do two begin at one byte.
class PieceTable {
 public:
  explicit PieceTable(std::vector<Piece>* all) : all_(*all) {}

  std::size_t Add(PieceKind kind, Span span, std::size_t program) {
    const auto [at, is_new] = ids_.insert({{kind, span.begin}, all_.size()});
    if (is_new) all_.push_back({kind, span, {}});
    all_[at->second].programs.push_back(program);
    return at->second;
  }

 private:
  std::vector<Piece>& all_;
  std::map<std::pair<PieceKind, std::uint32_t>, std::size_t> ids_;
};

Clause KeepTerms(const Clause& clause, const std::vector<std::size_t>& pieces,
                 const Kept& kept) {
  Clause shorter;
  std::size_t last = 0;
  for (std::size_t i = 0; i < clause.terms.size(); ++i) {
    if (!kept[pieces[i]]) continue;
    if (!shorter.terms.empty())
      shorter.connectives.push_back(
          clause.connectives[JoiningConnective(clause, last, i)]);
    shorter.terms.push_back(clause.terms[i]);
    last = i;
  }
  return shorter;
}

}  // namespace

Pieces PiecesOf(std::span<const MappedProgram> programs) {
  Pieces pieces;
  PieceTable table(&pieces.all);
  for (std::size_t p = 0; p < programs.size(); ++p) {
    std::vector<RulePieces> rules;
    for (const RuleSpans& spans : programs[p].map.rules) {
      RulePieces rule;
      rule.rule = table.Add(PieceKind::kRule, spans.rule, p);
      for (const Span span : spans.terms)
        rule.terms.push_back(table.Add(PieceKind::kTerm, span, p));
      for (const Span span : spans.symbols)
        rule.symbols.push_back(table.Add(PieceKind::kSymbol, span, p));
      rules.push_back(std::move(rule));
    }
    pieces.of.push_back(std::move(rules));
  }
  return pieces;
}

std::size_t JoiningConnective(const Clause& clause, std::size_t first,
                              std::size_t last) {
  const auto begin = clause.connectives.begin();
  const auto found =
      std::find(begin + static_cast<std::ptrdiff_t>(first),
                begin + static_cast<std::ptrdiff_t>(last), Connective::kOr);
  const auto at = static_cast<std::size_t>(found - begin);
  return at == last ? first : at;
}

std::optional<Genotype> KeepPieces(const Genotype& genotype,
                                   const std::vector<RulePieces>& rules,
                                   const Kept& kept) {
  Genotype shorter = genotype;
  shorter.rules.clear();
  for (std::size_t i = 0; i < rules.size(); ++i) {
    if (!kept[rules[i].rule]) continue;
    const Rule& from = genotype.rules[i];
    Rule rule{from.head, KeepTerms(from.clause, rules[i].terms, kept), {}};
    for (std::size_t s = 0; s < from.production.size(); ++s)
      if (kept[rules[i].symbols[s]])
        rule.production.push_back(from.production[s]);
    const bool needs_core =
        genotype.alphabet->is_built_in() && rule.head == plasticoding::kC;
    if (rule.production.empty() ||
        (needs_core && rule.production.front().id != plasticoding::kC))
      return std::nullopt;
    shorter.rules.push_back(std::move(rule));
  }
  return shorter;
}

}  // namespace plsc
