// Two versions of a genotype can be compared where both can be told what is
// sensed. Their states are united by name, the clauses of both are moved into
// that union, and its regimes are the environments to look at, each seen by
// either version in its own order of states. A state of other values cannot be
// united; then, or if there are too many environments, only those that both
// files declare under one name are compared, and the limitation is said.

#include "runtime/compare/environment_pairs.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "compiler/print.h"
#include "compiler/truth.h"
#include "runtime/develop/regimes.h"

namespace plsc {

namespace {

std::optional<std::size_t> IndexOf(const std::vector<State>& states,
                                   const std::string& name) {
  const auto found =
      std::find_if(states.begin(), states.end(),
                   [&](const State& state) { return state.name == name; });
  if (found == states.end()) return std::nullopt;
  return static_cast<std::size_t>(found - states.begin());
}

// What both versions mean by one state; nothing when they share no value that
// could be compared.
std::optional<State> Shared(const State& a, const State& b) {
  if (a == b) return a;
  if (a.type != StateType::kReal || b.type != a.type) return std::nullopt;
  State both = a;
  both.low = std::max(a.low, b.low);
  both.high = std::min(a.high, b.high);
  if (both.low > both.high) return std::nullopt;
  return both;
}

// The states of both, and where each version has them.
class StateUnion {
 public:
  StateUnion(const std::vector<State>& before, const std::vector<State>& after)
      : states_(before) {
    for (const State& state : after) {
      const auto same = IndexOf(states_, state.name);
      if (!same) {
        states_.push_back(state);
      } else if (const auto shared = Shared(states_[*same], state)) {
        states_[*same] = *shared;
      } else {
        problem_ = fmt::format("'sense {}' changed its values", state.name);
      }
    }
  }

  const std::vector<State>& states() const { return states_; }
  const std::string& problem() const { return problem_; }

  /// A rule's clause, asking about these states.
  Clause Moved(Clause clause, const std::vector<State>& from) const {
    for (Term& term : clause.terms) {
      const State& state = StateAt(from, term.state);
      term.state = static_cast<StateId>(*IndexOf(states_, state.name));
    }
    return clause;
  }

  /// `values` of these states in those of one version.
  Environment In(const std::vector<State>& version,
                 const std::vector<double>& values) const {
    Environment environment;
    for (const State& state : version)
      environment.values.push_back(values[*IndexOf(states_, state.name)]);
    return environment;
  }

  /// Nothing when it does not say all.
  std::optional<std::vector<double>> From(
      const std::vector<State>& version, const Environment& environment) const {
    std::vector<double> values;
    for (const State& state : states_) {
      const auto index = IndexOf(version, state.name);
      if (!index) return std::nullopt;
      values.push_back(environment.values[*index]);
    }
    return values;
  }

 private:
  std::vector<State> states_;
  std::string problem_;
};

std::string TextOf(const std::vector<double>& values,
                   const std::vector<State>& states) {
  if (states.empty()) return "any";
  return PrintEnvironment(Environment{values}, states);
}

// Environments of one name in both files.
SharedEnvironments Declared(const Program& before, const Program& after,
                            std::string limitation) {
  SharedEnvironments shared;
  shared.limitation = std::move(limitation);
  for (const NamedEnvironment& now : after.environments)
    for (const NamedEnvironment& then : before.environments)
      if (then.name == now.name)
        shared.environments.push_back(
            {PrintEnvironment(now.environment, after.genotype.states),
             {now.name},
             then.environment,
             now.environment});
  return shared;
}

std::vector<Clause> ClausesOfBoth(const StateUnion& all, const Genotype& before,
                                  const Genotype& after) {
  std::vector<Clause> clauses;
  for (const Genotype* one : {&before, &after})
    for (const Rule& rule : one->rules)
      clauses.push_back(all.Moved(rule.clause, one->states));
  return clauses;
}

}  // namespace

SharedEnvironments FindSharedEnvironments(const Program& before,
                                          const Program& after) {
  const std::vector<State>& old_states = before.genotype.states;
  const std::vector<State>& new_states = after.genotype.states;
  const StateUnion all(old_states, new_states);
  if (!all.problem().empty()) return Declared(before, after, all.problem());
  const std::vector<Clause> moved =
      ClausesOfBoth(all, before.genotype, after.genotype);
  std::vector<const Clause*> clauses;
  clauses.reserve(moved.size());
  for (const Clause& clause : moved) clauses.push_back(&clause);
  const StateSpace space(clauses, all.states());
  const auto regimes = FindRegimes(clauses, space);
  if (!regimes)
    return Declared(before, after,
                    "the clauses tell apart too many environments");
  SharedEnvironments shared;
  std::map<std::vector<bool>, std::size_t> by_clauses;
  for (const Regime& regime : *regimes) {
    const std::vector<double> values = space.At(regime.environment);
    by_clauses[WhichHold(clauses, values)] = shared.environments.size();
    shared.environments.push_back({TextOf(values, all.states()),
                                   {},
                                   all.In(old_states, values),
                                   all.In(new_states, values),
                                   all.states().empty()});
  }
  const auto name = [&](const Program& program) {
    for (const NamedEnvironment& named : program.environments) {
      const auto values = all.From(program.genotype.states, named.environment);
      if (!values) continue;
      const auto found = by_clauses.find(WhichHold(clauses, *values));
      if (found == by_clauses.end()) continue;  // beyond a range that shrank
      auto& names = shared.environments[found->second].names;
      if (std::find(names.begin(), names.end(), named.name) == names.end())
        names.push_back(named.name);
    }
  };
  name(after);
  name(before);
  return shared;
}

}  // namespace plsc
