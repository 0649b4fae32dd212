// Leaving bytes out of a text so that a person would not have left it
// otherwise. What goes is first a list of spans, sorted, of which some may lie
// within others; then the kept text is put together line by line: a line of
// which something was cut and nothing but blanks or a comment is left goes, a
// cut takes the blanks on one side along, and of two blank lines that meet one
// stays. Comments right above a rule that goes are part of its span.

#include "runtime/advice/trim_text.h"

#include <algorithm>
#include <string_view>

#include "grammar/keywords.h"

namespace plsc {

namespace {

constexpr std::string_view kBlanks = " \t";

// Where the keyword stands in [begin, end), comments left out; it is there.
Span FindKeyword(std::string_view text, std::string_view word, Span within) {
  for (std::uint32_t at = within.begin; at < within.end; ++at) {
    if (text[at] == '#') {
      at = static_cast<std::uint32_t>(
          std::min<std::size_t>(text.find('\n', at), within.end));
      continue;
    }
    const auto end = static_cast<std::uint32_t>(at + word.size());
    const bool begins_word = at == 0 || !IsWordCharacter(text[at - 1]);
    if (begins_word && text.substr(at, word.size()) == word &&
        !IsWordCharacter(text[end]))
      return {at, end};
  }
  return {within.end, within.end};
}

std::uint32_t LineBegin(std::string_view text, std::uint32_t at) {
  const std::size_t end =
      at == 0 ? std::string_view::npos : text.rfind('\n', at - 1);
  return end == std::string_view::npos ? 0
                                       : static_cast<std::uint32_t>(end + 1);
}

// With the comment lines right above it, if it begins its line; those that
// speak to the linter may mean more than this rule.
Span WithComments(std::string_view text, Span rule) {
  std::uint32_t begin = LineBegin(text, rule.begin);
  const auto before = text.substr(begin, rule.begin - begin);
  if (before.find_first_not_of(kBlanks) != std::string_view::npos) return rule;
  Span all = rule;
  while (begin > 0) {
    const std::uint32_t above = LineBegin(text, begin - 1);
    const auto line = text.substr(above, begin - 1 - above);
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string_view::npos || line[first] != '#' ||
        line.find("plsc:") != std::string_view::npos)
      break;
    all.begin = begin = above;
  }
  return all;
}

// What goes of one rule that stays.
class RuleCut {
 public:
  RuleCut(std::string_view text, const Rule& rule, const RuleSpans& spans)
      : text_(text), rule_(rule), spans_(spans) {}

  void CutTerms(const std::vector<std::size_t>& pieces, const Kept& kept,
                std::vector<Span>* cuts) const {
    std::optional<std::size_t> last;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (!kept[pieces[i]]) continue;
      if (!last && i > 0) cuts->push_back({spans_.clause.begin, TermBegin(i)});
      if (last && i - *last > 1) CutBetween(*last, i, cuts);
      last = i;
    }
    if (!last) {
      CutCondition(cuts);
    } else if (*last + 1 < pieces.size()) {
      cuts->push_back({TermEnd(*last), spans_.clause.end});
    }
  }

  void CutSymbols(const std::vector<std::size_t>& pieces, const Kept& kept,
                  std::vector<Span>* cuts) const {
    for (std::size_t i = 0; i < pieces.size(); ++i)
      if (!kept[pieces[i]]) cuts->push_back(spans_.symbols[i]);
  }

 private:
  std::uint32_t TermBegin(std::size_t term) const {
    return spans_.terms[term].begin;
  }
  std::uint32_t TermEnd(std::size_t term) const {
    return spans_.terms[term].end;
  }

  // Of the gaps between the two, the one of the joining connective stays.
  void CutBetween(std::size_t first, std::size_t last,
                  std::vector<Span>* cuts) const {
    const std::size_t gap = JoiningConnective(rule_.clause, first, last);
    if (gap > first) cuts->push_back({TermEnd(first), TermEnd(gap)});
    if (gap + 1 < last) cuts->push_back({TermBegin(gap + 1), TermBegin(last)});
  }

  // `if ... then`
  void CutCondition(std::vector<Span>* cuts) const {
    const Span before{spans_.head.end, spans_.clause.begin};
    const Span behind{spans_.clause.end, spans_.symbols.front().begin};
    cuts->push_back({FindKeyword(text_, "if", before).begin,
                     FindKeyword(text_, "then", behind).end});
  }

  std::string_view text_;
  const Rule& rule_;
  const RuleSpans& spans_;
};

std::vector<Span> CutsOf(std::string_view text,
                         std::span<const MappedProgram> programs,
                         const Pieces& pieces, const Kept& kept) {
  std::vector<Span> cuts;
  for (std::size_t p = 0; p < programs.size(); ++p) {
    const SourceMap& map = programs[p].map;
    for (std::size_t r = 0; r < map.rules.size(); ++r) {
      const RulePieces& rule = pieces.of[p][r];
      if (!kept[rule.rule]) {
        cuts.push_back(WithComments(text, map.rules[r].rule));
        continue;
      }
      const RuleCut cut(text, programs[p].program.genotype.rules[r],
                        map.rules[r]);
      if (!rule.terms.empty()) cut.CutTerms(rule.terms, kept, &cuts);
      cut.CutSymbols(rule.symbols, kept, &cuts);
    }
  }
  const auto is_before = [](Span a, Span b) {
    return a.begin != b.begin ? a.begin < b.begin : a.end < b.end;
  };
  std::sort(cuts.begin(), cuts.end(), is_before);
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  return cuts;
}

// Puts kept text together line by line.
class Joiner {
 public:
  void Keep(std::string_view kept) {
    if (is_behind_cut_) kept = Tidied(kept);
    is_behind_cut_ = false;
    for (const char c : kept) {
      line_ += c;
      if (c == '\n') EndLine();
    }
  }
  void Cut() {
    is_cut_ = true;
    is_behind_cut_ = true;
  }
  std::string Joined() {
    if (!line_.empty()) EndLine();
    return std::move(text_);
  }

 private:
  // A cut takes the blanks behind it along, or at the line's end those before.
  std::string_view Tidied(std::string_view kept) {
    const std::size_t first = kept.find_first_not_of(kBlanks);
    const bool has_blank =
        line_.empty() || kBlanks.find(line_.back()) != std::string_view::npos;
    if (first == std::string_view::npos) return has_blank ? "" : kept;
    if (line_.empty()) return kept.substr(first);
    if (kept[first] == '\n' || kept[first] == '\r') {
      line_.resize(line_.find_last_not_of(kBlanks) + 1);
      return kept.substr(first);
    }
    return has_blank ? kept.substr(first) : kept;
  }

  void EndLine() {
    const std::size_t first = line_.find_first_not_of(" \t\r\n");
    const bool is_blank = first == std::string::npos;
    const bool is_gone = is_cut_ && (is_blank || line_[first] == '#');
    // Of two blank lines around a rule that went, one is enough.
    const bool is_second = is_blank && was_gone_ && was_blank_;
    if (!is_gone && !is_second) {
      text_ += line_;
      was_blank_ = is_blank;
    }
    if (!is_second) was_gone_ = is_gone;
    is_cut_ = false;
    line_.clear();
  }

  std::string text_;
  std::string line_;
  bool is_cut_ = false;  // something of the line is
  bool is_behind_cut_ = false;
  bool was_gone_ = false;
  bool was_blank_ = false;
};

}  // namespace

std::string KeepText(const Source& source,
                     std::span<const MappedProgram> programs,
                     const Pieces& pieces, const Kept& kept) {
  const std::string_view text = source.text();
  Joiner joiner;
  std::uint32_t copied = 0;
  for (const Span cut : CutsOf(text, programs, pieces, kept)) {
    if (cut.begin > copied)
      joiner.Keep(text.substr(copied, cut.begin - copied));
    joiner.Cut();
    copied = std::max(copied, cut.end);
  }
  joiner.Keep(text.substr(copied));
  return joiner.Joined();
}

}  // namespace plsc
