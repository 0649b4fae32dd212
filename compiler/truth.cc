#include "compiler/truth.h"

#include <algorithm>

namespace plsc {

namespace {

bool TermHolds(const Term& term, std::span<const double> values) {
  const double value = values[static_cast<std::size_t>(term.state)];
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

// The ends, the thresholds within, and a value between each two neighbours.
std::vector<double> RealSamples(const State& state,
                                const std::vector<double>& thresholds) {
  std::vector<double> points = {state.low, state.high};
  for (const double threshold : thresholds)
    if (threshold > state.low && threshold < state.high)
      points.push_back(threshold);
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::vector<double> samples;
  for (std::size_t i = 0; i < points.size(); ++i) {
    // Halved first: the sum of two large bounds could overflow.
    if (i > 0) samples.push_back(points[i - 1] / 2 + points[i] / 2);
    samples.push_back(points[i]);
  }
  return samples;
}

std::vector<double> Samples(const State& state,
                            const std::vector<double>& thresholds) {
  switch (state.type) {
    case StateType::kBool:
      return {0, 1};
    case StateType::kReal:
      return RealSamples(state, thresholds);
    case StateType::kEnum:
      break;
  }
  std::vector<double> samples(state.values.size());
  for (std::size_t i = 0; i < samples.size(); ++i)
    samples[i] = static_cast<double>(i);
  return samples;
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

StateSpace::StateSpace(std::span<const Clause* const> clauses,
                       const std::vector<State>& states)
    : state_count_(states.size()) {
  for (const Clause* clause : clauses)
    for (const Term& term : clause->terms) ids_.push_back(term.state);
  std::sort(ids_.begin(), ids_.end());
  ids_.erase(std::unique(ids_.begin(), ids_.end()), ids_.end());
  std::size_t size = 1;
  for (const StateId id : ids_) {
    std::vector<double> thresholds;
    for (const Clause* clause : clauses)
      for (const Term& term : clause->terms)
        if (term.state == id) thresholds.push_back(term.value);
    samples_.push_back(
        Samples(states[static_cast<std::size_t>(id)], thresholds));
    size *= samples_.back().size();
    if (size > kMaxCombinations) return;
  }
  size_ = static_cast<int>(size);
}

std::vector<double> StateSpace::At(int index) const {
  std::vector<double> values(state_count_, 0.0);
  auto rest = static_cast<std::size_t>(index);
  // The last state varies fastest, as in a written truth table.
  for (std::size_t i = ids_.size(); i-- > 0;) {
    const std::vector<double>& samples = samples_[i];
    values[static_cast<std::size_t>(ids_[i])] = samples[rest % samples.size()];
    rest /= samples.size();
  }
  return values;
}

std::optional<TruthCount> CountTruth(const Clause& clause,
                                     const std::vector<State>& states) {
  const Clause* const one = &clause;
  const StateSpace space({&one, 1}, states);
  if (!space.size()) return std::nullopt;
  TruthCount count;
  count.total = *space.size();
  for (int i = 0; i < count.total; ++i)
    if (ClauseHolds(clause, space.At(i))) ++count.holds;
  return count;
}

}  // namespace plsc
