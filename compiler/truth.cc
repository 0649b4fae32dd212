// A clause has no parentheses and `and` binds tighter than `or`: it is a
// disjunction of conjunctions. One pass from left to right with two values is
// therefore enough to evaluate it: the conjunction that is being read
// (`group`), and the disjunction of those that are finished. The pass is
// written three times, over a truth value (ClauseHolds, for development), over
// a table of 64 environments a word (Tabulate) and over a single word
// (CountWord). They must agree: what a warning says of a clause would else not
// be what robots do. Tests compare them environment by environment.
//
// Tables are made without asking any row. A StateSpace counts its environments
// like an odometer, the last state fastest, so that the rows in which one term
// holds are runs of `stride` bits, repeated with a period of stride times the
// number of the state's classes. Terms times rows / 64 operations: of 16 bool
// states a term is a thousand words.
//
// Bits beyond the last row are 0 at all times. Count and First look at whole
// words; a bit left there would be an environment that does not exist.

#include "compiler/truth.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>

namespace plsc {

namespace {

bool Compare(const Term& term, double value) {
  switch (term.comparison) {
    case Comparison::kEqual:
      return value == term.value;
    case Comparison::kNotEqual:
      return value != term.value;
    case Comparison::kLess:
      return value < term.value;
    case Comparison::kLessEqual:
      return value <= term.value;
    case Comparison::kGreater:
      return value > term.value;
    case Comparison::kGreaterEqual:
      return value >= term.value;
  }
  return false;
}

bool TermHolds(const Term& term, std::span<const double> values) {
  return Compare(term, values[static_cast<std::size_t>(term.state)]);
}

// In which environments a term holds: runs of `stride` bits that repeat.
TruthTable TabulateTerm(const Term& term, const StateSpace& space) {
  const auto found =
      std::find(space.states().begin(), space.states().end(), term.state);
  assert(found != space.states().end());
  const auto position =
      static_cast<std::size_t>(found - space.states().begin());
  const std::vector<ValueClass>& classes = space.classes(position);
  const std::size_t stride = space.stride(position);
  const auto size = static_cast<std::size_t>(*space.size());
  const std::size_t period = stride * classes.size();
  // Most periods fit a word many times: make one word of it. Those that do not
  // divide 64 (an enum of three values) fall otherwise in each word.
  const bool is_short = 64 % period == 0;
  TruthTable table(is_short ? 64 : *space.size(), false);
  const std::size_t made = is_short ? 64 : size;
  for (std::size_t k = 0; k < classes.size(); ++k) {
    if (!Compare(term, classes[k].value)) continue;
    for (std::size_t begin = k * stride; begin < made; begin += period)
      table.SetRange(begin, begin + stride);
  }
  if (is_short) table.Repeat(*space.size());
  return table;
}

// The bits [begin, end) of a word; end is at most 64.
std::uint64_t Mask(std::size_t begin, std::size_t end) {
  const std::uint64_t below_end =
      end == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << end) - 1;
  return below_end & (~std::uint64_t{0} << begin);
}

// Row i of a table over n bool states is bit i, and in row i state k is True
// where bit k of i is set.
constexpr std::array<std::uint64_t, 6> kTrueRows = {
    0xAAAAAAAAAAAAAAAA, 0xCCCCCCCCCCCCCCCC, 0xF0F0F0F0F0F0F0F0,
    0xFF00FF00FF00FF00, 0xFFFF0000FFFF0000, 0xFFFFFFFF00000000};

// What CountTruth says of a clause about up to six states, all bool, which a
// word holds the table of; nothing for others. Clauses of an evolved genotype
// are of this kind, and each is counted whenever one is compiled.
std::optional<TruthCount> CountWord(const Clause& clause,
                                    const std::vector<State>& states) {
  std::array<StateId, kTrueRows.size()> known{};
  std::size_t count = 0;
  std::uint64_t all = 0;
  std::uint64_t group = ~std::uint64_t{0};
  for (std::size_t i = 0; i < clause.terms.size(); ++i) {
    const Term& term = clause.terms[i];
    if (StateAt(states, term.state).type != StateType::kBool)
      return std::nullopt;
    std::size_t place = 0;
    while (place < count && known[place] != term.state) ++place;
    if (place == known.size()) return std::nullopt;
    if (place == count) known[count++] = term.state;
    const std::uint64_t rows = (Compare(term, 1) ? kTrueRows[place] : 0) |
                               (Compare(term, 0) ? ~kTrueRows[place] : 0);
    if (i > 0 && clause.connectives[i - 1] == Connective::kOr) {
      all |= group;
      group = rows;
    } else {
      group &= rows;
    }
  }
  const int total = 1 << count;
  return TruthCount{
      std::popcount((all | group) & Mask(0, static_cast<std::size_t>(total))),
      total};
}

}  // namespace

bool ClauseHolds(const Clause& clause, std::span<const double> values) {
  if (clause.terms.empty()) return true;
  // A clause is an `or` of groups of terms joined by `and`.
  bool group = TermHolds(clause.terms[0], values);
  for (std::size_t i = 1; i < clause.terms.size(); ++i) {
    const bool holds = TermHolds(clause.terms[i], values);
    if (clause.connectives[i - 1] == Connective::kAnd) {
      group = group && holds;
    } else {
      if (group) return true;
      group = holds;
    }
  }
  return group;
}

TruthTable::TruthTable(int size, bool value)
    : size_(size), words_((static_cast<std::size_t>(size) + 63) / 64, 0) {
  if (value) SetRange(0, static_cast<std::size_t>(size));
}

int TruthTable::Count() const {
  int count = 0;
  for (const std::uint64_t word : words_) count += std::popcount(word);
  return count;
}

std::optional<int> TruthTable::First() const {
  for (std::size_t i = 0; i < words_.size(); ++i)
    if (words_[i] != 0)
      return static_cast<int>(i * 64) + std::countr_zero(words_[i]);
  return std::nullopt;
}

void TruthTable::SetRange(std::size_t begin, std::size_t end) {
  while (begin < end) {
    const std::size_t word_end = std::min(end, (begin / 64 + 1) * 64);
    words_[begin / 64] |= Mask(begin % 64, (word_end - 1) % 64 + 1);
    begin = word_end;
  }
}

void TruthTable::ClearUnused() {
  const std::size_t used = static_cast<std::size_t>(size_) % 64;
  if (used != 0) words_.back() &= Mask(0, used);
}

void TruthTable::Repeat(int size) {
  assert(size_ == 64 && size > 0);
  size_ = size;
  words_.resize((static_cast<std::size_t>(size) + 63) / 64, words_[0]);
  ClearUnused();
}

void TruthTable::Invert() {
  for (std::uint64_t& word : words_) word = ~word;
  ClearUnused();
}

TruthTable& TruthTable::operator&=(const TruthTable& other) {
  assert(size_ == other.size_);
  for (std::size_t i = 0; i < words_.size(); ++i) words_[i] &= other.words_[i];
  return *this;
}

TruthTable& TruthTable::operator|=(const TruthTable& other) {
  assert(size_ == other.size_);
  for (std::size_t i = 0; i < words_.size(); ++i) words_[i] |= other.words_[i];
  return *this;
}

// The same pass as in ClauseHolds, on all environments at once.
TruthTable Tabulate(const Clause& clause, const StateSpace& space) {
  if (clause.terms.empty()) return {*space.size(), true};
  TruthTable all(*space.size(), false);
  TruthTable group = TabulateTerm(clause.terms[0], space);
  for (std::size_t i = 1; i < clause.terms.size(); ++i) {
    if (clause.connectives[i - 1] == Connective::kAnd) {
      group &= TabulateTerm(clause.terms[i], space);
    } else {
      all |= group;
      group = TabulateTerm(clause.terms[i], space);
    }
  }
  all |= group;
  return all;
}

std::optional<TruthCount> CountTruth(const Clause& clause,
                                     const std::vector<State>& states) {
  if (const auto count = CountWord(clause, states)) return count;
  const Clause* const one = &clause;
  const StateSpace space({&one, 1}, states);
  if (!space.size()) return std::nullopt;
  return TruthCount{Tabulate(clause, space).Count(), *space.size()};
}

}  // namespace plsc
