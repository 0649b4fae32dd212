#pragma once

// What a parent hands down, as the experiment's `inheritance` says. Beyond the
// genotype as it is written there are two ways in which a life can reach the
// next generation: rules that stay joined as the last season joined them, and
// what was sensed then.

#include <map>
#include <string>

#include "runtime/evolve/experiment.h"
#include "runtime/evolve/individual.h"

namespace plsc {

/// What regulated it in the last season that it reached: state to value.
/// Empty if it senses nothing, or reached none.
std::map<std::string, std::string> LastSenses(const Individual& parent);

/// Of each symbol with several active rules, the first active one becomes what
/// Regulate joins of them; all other rules stay, so that symbols of the later
/// ones are there twice.
Genotype WithJoinedRules(Genotype genotype, const Environment& environment);

/// The genotype that goes into crossover. For kJoined, a parent that reached
/// no season hands down its genotype as it is written.
Genotype HandedDown(const Individual& parent, Inheritance inheritance);

}  // namespace plsc
