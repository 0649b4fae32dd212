#pragma once

// What one genotype is worth in a scenario: the results of a whole life
// (runtime/life/life).

#include "compiler/genotype.h"
#include "runtime/life/disturbances.h"
#include "runtime/life/season_result.h"
#include "runtime/scenario/scenario.h"

namespace plsc {

/// All seasons.
Evaluation Evaluate(const Genotype& genotype, const Scenario& scenario,
                    const Disturbances& disturbances = {});

}  // namespace plsc
