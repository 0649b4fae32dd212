#pragma once

// What a robot of a genotype senses in the seasons of a scenario, known without
// living them: the environments that it develops in.

#include <vector>

#include "compiler/program.h"
#include "runtime/scenario/scenario.h"

namespace plsc {

/// By seasons, under their names. What it feels is felt where lives start; one
/// that lives on from season to season may feel otherwise where it has come to
/// (PossibleEnvironments). What it senses must be known (CheckSenses).
std::vector<NamedEnvironment> SeasonEnvironments(const Genotype& genotype,
                                                 const Scenario& scenario);

/// Every environment that it may develop in, whatever its life: a season that
/// is reached in mid-life, on ground that is not level, counts once felt level
/// ("hill, level") and once felt inclined.
std::vector<NamedEnvironment> PossibleEnvironments(const Genotype& genotype,
                                                   const Scenario& scenario);

}  // namespace plsc
