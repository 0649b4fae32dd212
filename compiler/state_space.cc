// Which environments have to be looked at to know what holds in all. There are
// as many as doubles for a real state, but clauses compare with constants only,
// so between two neighbouring thresholds no clause changes its mind. Each
// state's values are cut into classes that no term tells apart, and the
// environments of the space are the products of classes, one member standing
// for each. What is true of every member is true everywhere: linting, regimes,
// trimming and comparisons rest on this.
//
// A threshold cuts a range once or twice. `t < 5` tells what is below 5 from 5;
// `t <= 5` tells 5 from what is above; `t = 5` does both, and 5 is a class by
// itself. A class counts only if some double lies in it: between neighbouring
// doubles there is none, and to report the environment "t > a and t < next
// after a" would be to warn of nothing.
//
// The number of environments is a product and explodes; beyond kMaxCombinations
// there is no size, and whoever asks must do without (it is checked after each
// factor, so the product never overflows).

#include "compiler/state_space.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "grammar/number.h"

namespace plsc {

namespace {

// Where the truth of some term changes: at the threshold itself, below it
// (t < 5 ends) or above it (t <= 5 ends).
struct Cut {
  double at = 0;
  bool is_below = false;
  bool is_above = false;
};

Cut CutOf(const Term& term) {
  switch (term.comparison) {
    case Comparison::kLess:
    case Comparison::kGreaterEqual:
      return {term.value, true, false};
    case Comparison::kLessEqual:
    case Comparison::kGreater:
      return {term.value, false, true};
    case Comparison::kEqual:
    case Comparison::kNotEqual:
      break;
  }
  return {term.value, true, true};
}

// The cuts within the state's range, one a threshold, in order. Thresholds
// outside of it tell nothing apart that can be sensed.
std::vector<Cut> CutsOf(const State& state, std::vector<Cut> cuts) {
  std::erase_if(cuts, [&](const Cut& cut) {
    return cut.at < state.low || cut.at > state.high;
  });
  std::sort(cuts.begin(), cuts.end(),
            [](const Cut& a, const Cut& b) { return a.at < b.at; });
  std::vector<Cut> merged;
  for (const Cut& cut : cuts) {
    if (merged.empty() || merged.back().at != cut.at) {
      merged.push_back(cut);
      continue;
    }
    merged.back().is_below |= cut.is_below;
    merged.back().is_above |= cut.is_above;
  }
  return merged;
}

// A member of the class; nothing when no double lies within.
std::optional<double> MemberOf(const ValueClass& c) {
  // Halved first: the sum of two large bounds could overflow.
  const double middle = c.low / 2 + c.high / 2;
  if (middle > c.low && middle < c.high) return middle;
  if (c.has_low && (c.low < c.high || c.has_high)) return c.low;
  if (c.has_high && c.low < c.high) return c.high;
  const double next = std::nextafter(c.low, c.high);
  if (next > c.low && next < c.high) return next;
  return std::nullopt;
}

std::vector<ValueClass> RealClasses(const State& state,
                                    const std::vector<Cut>& cuts) {
  std::vector<ValueClass> classes;
  ValueClass open;
  open.low = state.low;
  const auto close = [&](double at, bool has_it) {
    open.high = at;
    open.has_high = has_it;
    if (const auto member = MemberOf(open)) {
      open.value = *member;
      classes.push_back(open);
    }
    open.low = at;
    open.has_low = !has_it;
  };
  for (const Cut& cut : cuts) {
    if (cut.is_below) close(cut.at, false);
    if (cut.is_above) close(cut.at, true);
  }
  close(state.high, true);
  return classes;
}

// Each value that a term names is told apart from all others; those that no
// term names are one class.
std::vector<ValueClass> NamedClasses(std::size_t count,
                                     const std::vector<Cut>& cuts) {
  std::vector<bool> is_named(count);
  // A term of such a state compares with the number of a value.
  for (const Cut& cut : cuts) is_named[static_cast<std::size_t>(cut.at)] = true;
  std::vector<ValueClass> classes;
  std::optional<std::size_t> rest;
  for (std::size_t value = 0; value < count; ++value) {
    const int number = static_cast<int>(value);
    if (!is_named[value] && rest) {
      classes[*rest].named.push_back(number);
      continue;
    }
    if (!is_named[value]) rest = classes.size();
    ValueClass one;
    one.value = number;
    one.named = {number};
    classes.push_back(std::move(one));
  }
  return classes;
}

std::vector<ValueClass> ClassesOf(const State& state, std::vector<Cut> cuts) {
  if (state.type == StateType::kReal)
    return RealClasses(state, CutsOf(state, std::move(cuts)));
  const std::size_t count =
      state.type == StateType::kBool ? 2 : state.values.size();
  return NamedClasses(count, cuts);
}

std::string NameOf(int value, const State& state) {
  if (state.type == StateType::kBool) return value != 0 ? "True" : "False";
  return state.values[static_cast<std::size_t>(value)];
}

}  // namespace

std::string DescribeClass(const ValueClass& values, const State& state) {
  if (state.type != StateType::kReal) {
    std::vector<std::string> names;
    for (const int value : values.named) names.push_back(NameOf(value, state));
    return fmt::format("{} = {}", state.name, fmt::join(names, "|"));
  }
  if (values.low == values.high)
    return fmt::format("{} = {}", state.name, PrintNumber(values.low));
  std::string text;
  if (values.low != state.low || !values.has_low)
    text = fmt::format("{} {} {}", state.name, values.has_low ? ">=" : ">",
                       PrintNumber(values.low));
  if (values.high != state.high || !values.has_high)
    text += fmt::format("{}{} {} {}", text.empty() ? "" : " and ", state.name,
                        values.has_high ? "<=" : "<", PrintNumber(values.high));
  return text;
}

std::string ClassLabel(const ValueClass& values, const State& state) {
  if (state.type != StateType::kReal) {
    std::vector<std::string> names;
    for (const int value : values.named) names.push_back(NameOf(value, state));
    return fmt::format("{}", fmt::join(names, "|"));
  }
  if (values.low == values.high) return PrintNumber(values.low);
  return fmt::format("{}{}..{}{}", values.has_low ? "" : ">",
                     PrintNumber(values.low), values.has_high ? "" : "<",
                     PrintNumber(values.high));
}

std::vector<const Clause*> ClausesOf(const Genotype& genotype) {
  std::vector<const Clause*> clauses;
  clauses.reserve(genotype.rules.size());
  for (const Rule& rule : genotype.rules) clauses.push_back(&rule.clause);
  return clauses;
}

std::vector<const Clause*> ClausesOf(const Genotype& one,
                                     const Genotype& other) {
  std::vector<const Clause*> clauses = ClausesOf(one);
  const std::vector<const Clause*> more = ClausesOf(other);
  clauses.insert(clauses.end(), more.begin(), more.end());
  return clauses;
}

StateSpace::StateSpace(const Genotype& genotype)
    : StateSpace(ClausesOf(genotype), genotype.states) {}

StateSpace::StateSpace(std::span<const Clause* const> clauses,
                       const std::vector<State>& states) {
  first_.reserve(states.size());
  for (const State& state : states)
    first_.push_back(state.type == StateType::kReal ? state.low : 0);
  for (const Clause* clause : clauses)
    for (const Term& term : clause->terms) ids_.push_back(term.state);
  std::sort(ids_.begin(), ids_.end());
  ids_.erase(std::unique(ids_.begin(), ids_.end()), ids_.end());
  std::size_t size = 1;
  for (const StateId id : ids_) {
    std::vector<Cut> cuts;
    for (const Clause* clause : clauses)
      for (const Term& term : clause->terms)
        if (term.state == id) cuts.push_back(CutOf(term));
    classes_.push_back(ClassesOf(StateAt(states, id), std::move(cuts)));
    size *= classes_.back().size();
    // Without a size there are no strides either, and nobody may ask for one.
    if (size > kMaxCombinations) return;
  }
  strides_.resize(ids_.size());
  std::size_t stride = 1;
  for (std::size_t i = ids_.size(); i-- > 0;) {
    strides_[i] = stride;
    stride *= classes_[i].size();
  }
  size_ = static_cast<int>(size);
}

// The digits of `index` are the classes, the lowest that of the last state.
std::vector<double> StateSpace::At(int index) const {
  std::vector<double> values = first_;
  for (std::size_t i = 0; i < ids_.size(); ++i)
    values[static_cast<std::size_t>(ids_[i])] =
        classes_[i][ClassAt(index, i)].value;
  return values;
}

std::string StateSpace::Describe(int index,
                                 const std::vector<State>& states) const {
  std::string text;
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    const std::string part =
        DescribeClass(classes_[i][ClassAt(index, i)], StateAt(states, ids_[i]));
    if (part.empty()) continue;
    if (!text.empty()) text += " and ";
    text += part;
  }
  return text.empty() ? "always" : text;
}

}  // namespace plsc
