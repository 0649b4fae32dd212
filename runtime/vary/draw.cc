// The distributions of the paper's Table 1 and "Initialization". Draws are made
// in a fixed order, category or state first, then value, then arguments from
// left to right; which numbers of a stream go where is part of every result.

#include "runtime/vary/draw.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace plsc {

namespace {

double DrawArgument(const Parameter& parameter, Rng& rng) {
  switch (parameter.sampling) {
    case Sampling::kUniform:
      return rng.Uniform(parameter.low, parameter.high);
    case Sampling::kNormal:
      return rng.Normal();
    case Sampling::kCeilAbsNormal:
      // 0 would come of a normal number of exactly 0; edges count from 1.
      return std::max(1.0, std::ceil(std::abs(rng.Normal())));
  }
  assert(false);
  return 0;
}

Comparison DrawOrder(Rng& rng) {
  constexpr Comparison kOrders[] = {Comparison::kLess, Comparison::kLessEqual,
                                    Comparison::kGreater,
                                    Comparison::kGreaterEqual};
  return kOrders[rng.Index(std::size(kOrders))];
}

}  // namespace

Symbol DrawSymbol(const Alphabet& alphabet, Category category, Rng& rng) {
  std::vector<SymbolId> ids = alphabet.OfCategory(category);
  std::erase(ids, plasticoding::kC);
  Symbol symbol;
  symbol.id = ids[rng.Index(ids.size())];
  const std::vector<Parameter>& parameters = alphabet[symbol.id].parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    symbol.arguments[i] = DrawArgument(parameters[i], rng);
  return symbol;
}

Term DrawTerm(const std::vector<State>& states, Rng& rng) {
  const auto id = static_cast<StateId>(rng.Index(states.size()));
  return DrawComparison(states, id, rng);
}

Term DrawComparison(const std::vector<State>& states, StateId id, Rng& rng) {
  const State& state = StateAt(states, id);
  Term term;
  term.state = id;
  switch (state.type) {
    case StateType::kBool:
      term.value = static_cast<double>(rng.Index(2));
      break;
    case StateType::kEnum:
      if (rng.Index(2) == 1) term.comparison = Comparison::kNotEqual;
      term.value = static_cast<double>(rng.Index(state.values.size()));
      break;
    case StateType::kReal:
      term.comparison = DrawOrder(rng);
      term.value = rng.Uniform(state.low, state.high);
      break;
  }
  return term;
}

Connective DrawConnective(Rng& rng) {
  return rng.Index(2) == 0 ? Connective::kAnd : Connective::kOr;
}

}  // namespace plsc
