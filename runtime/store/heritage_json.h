#pragma once

// How a robot of a run came about, as JSON, for everything that prints it.

#include <nlohmann/json.hpp>
#include <vector>

#include "runtime/evolve/individual.h"

namespace plsc {

/// parents (ids), from_second (symbols whose rules are the second parent's),
/// mutation and mutated_rule (from 1; null if there was none), senses (state to
/// value, inherited; as EnvironmentJson).
nlohmann::ordered_json HeritageJson(const Heritage& heritage,
                                    const Alphabet& alphabet,
                                    const std::vector<State>& states);

}  // namespace plsc
