#pragma once

// What a parent hands down, as the experiment's `inheritance` says. Beyond the
// genotype as it is written there are two ways in which a life can reach the
// next generation: rules that stay joined as the last season joined them, and
// what was sensed then.

#include "runtime/evolve/experiment.h"
#include "runtime/evolve/individual.h"
#include "runtime/life/season_result.h"

namespace plsc {

/// What it sensed in the last season that it reached. Empty if it senses
/// nothing, or reached none.
Senses LastSenses(const Individual& parent);

/// Of each symbol with several active rules, the first active one becomes what
/// Regulate joins of them; all other rules stay, so that symbols of the later
/// ones are there twice.
Genotype WithJoinedRules(Genotype genotype, const Environment& environment);

/// The genotype that goes into crossover. With Inheritance::kJoined, rules are
/// joined as in the last season that the robot developed for: the last that it
/// reached, or its birth if plasticity ends there.
Genotype HandedDown(const Individual& parent, const Experiment& experiment);

}  // namespace plsc
