#pragma once

// Pieces of lives by worker processes: requests and answers as texts. A
// genotype goes out as canonical text with what it inherits and the seasons to
// simulate; what the simulator tells comes back, every double bit for bit.

#include <string>
#include <vector>

#include "runtime/evolve/experiment.h"
#include "runtime/life/life_plan.h"
#include "runtime/life/simulated.h"
#include "runtime/workers/workers.h"

namespace plsc {

/// What a worker is asked to simulate.
std::string RequestFor(const Genotype& genotype, const Senses& inherited,
                       const LifePiece& piece,
                       const Disturbances& disturbances = {});

/// What workers do with requests for the planner's scenario.
Work WorkOf(LifePlanner planner);

/// WorkOf the scenario of an experiment as PrintExperiment writes it, for
/// workers that know of a run only that text.
Work WorkFor(const std::string& experiment);

/// s without an answer after which a worker hangs rather than works: far more
/// than the largest robot takes, so that it is never a matter of speed.
double HangSeconds(const Experiment& experiment);

/// What a reply means, an item for each of the piece's `seasons`. Where the
/// workers died each has the outcome kWorkerDied.
std::vector<Simulated> SimulatedOf(const Reply& reply, std::size_t seasons);

}  // namespace plsc
