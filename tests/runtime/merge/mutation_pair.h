#pragma once

// Two independent mutations of one random genotype, as evolution makes them,
// and what both together are: the oracle of merges. It knows nothing of
// merging: it finds out what each mutation did, and does it to the other's
// result.

#include <cstdint>
#include <optional>

#include "compiler/genotype.h"
#include "runtime/vary/mutate.h"

namespace plsc::test {

struct MutationPair {
  Genotype base;
  Genotype ours;    ///< differs from base
  Genotype theirs;  ///< likewise
  Mutation our_mutation;
  Mutation their_mutation;
  /// Both mutations, in either order, whatever equal neighbours were meant;
  /// nothing when they touch the same, so that there is no such thing. One
  /// mutation that both made counts once.
  std::optional<Genotype> composed;
};

/// The same for the same number. The paper's genotypes and mutations, with the
/// streams that evolution would take; every 4th has two states, and a third of
/// those a real one.
MutationPair DrawMutationPair(std::uint64_t number);

}  // namespace plsc::test
