// The text that Print writes is the same for all genotypes that say the same,
// but for the name and for orders that mean nothing: states are looked up by
// name, and values of an enum by theirs. They are sorted first, and every term
// is renumbered with them. Sorting more than that (rules of a head, terms,
// symbols) would call two genotypes one that mutate or develop differently.

#include "runtime/develop/genotype_key.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "compiler/print.h"

namespace plsc {

namespace {

// Where each of `names` stands once they are sorted.
std::vector<std::size_t> SortedPlaces(const std::vector<std::string>& names) {
  std::vector<std::size_t> order(names.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return names[a] < names[b]; });
  std::vector<std::size_t> places(names.size());
  for (std::size_t i = 0; i < order.size(); ++i) places[order[i]] = i;
  return places;
}

template <typename T>
std::vector<T> Moved(const std::vector<T>& from,
                     const std::vector<std::size_t>& places) {
  std::vector<T> to(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) to[places[i]] = from[i];
  return to;
}

}  // namespace

Genotype Canonical(Genotype genotype) {
  std::vector<std::string> names;
  std::vector<std::vector<std::size_t>> value_places;
  for (State& state : genotype.states) {
    names.push_back(state.name);
    value_places.push_back(SortedPlaces(state.values));
    state.values = Moved(state.values, value_places.back());
  }
  const std::vector<std::size_t> places = SortedPlaces(names);
  genotype.states = Moved(genotype.states, places);
  for (Rule& rule : genotype.rules)
    for (Term& term : rule.clause.terms) {
      const auto state = static_cast<std::size_t>(term.state);
      if (!value_places[state].empty())
        term.value = static_cast<double>(
            value_places[state][static_cast<std::size_t>(term.value)]);
      term.state = static_cast<StateId>(places[state]);
    }
  return genotype;
}

Key GenotypeKey(const Genotype& genotype) {
  Genotype nameless = Canonical(genotype);
  nameless.name = "unnamed";  // what a file without a name has
  return KeyOf(Print(nameless));
}

}  // namespace plsc
