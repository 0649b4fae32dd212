#pragma once

// Evaluations by worker processes: genotypes go out as canonical text, and
// evaluations come back, in any order.

#include <optional>
#include <string>
#include <vector>

#include "runtime/evolve/evolve.h"
#include "runtime/evolve/workers.h"

namespace plsc {

/// What workers do with a genotype's text: compile, evaluate, pack.
Work JudgeWith(Evaluator evaluate);

/// What a reply means. Where workers died, each of `seasons` has the outcome
/// kWorkerDied and no fitness.
Evaluation EvaluationOf(const Reply& reply, const std::vector<Season>& seasons);

}  // namespace plsc
