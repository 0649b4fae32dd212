#pragma once

// What a genotype must go on to develop into while `plsc trim` leaves things
// out of it, and whether it still does.

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "compiler/compile.h"
#include "runtime/advice/trim_pieces.h"
#include "runtime/develop/developed.h"
#include "runtime/develop/regimes.h"

namespace plsc {

/// Environments that count; all that clauses tell apart without them.
using LivedEnvironments = std::optional<std::vector<NamedEnvironment>>;

struct TrimTarget {
  const MappedProgram* mapped = nullptr;  ///< as it was written
  LivedEnvironments lived;
  /// Of the written clauses; those that are left tell no more apart.
  StateSpace space;
  Genotype current;
  /// Of `current`, that count; every environment of a regime has developed the
  /// same.
  std::vector<Regime> regimes;
  std::map<std::vector<RuleIndex>, Developed> developed;  ///< of `current`
  std::vector<std::size_t> tests;  ///< of the file, that pass
};

/// `mapped` must outlive it. P4001 or P4003 where it cannot be developed
/// everywhere.
Result<TrimTarget> MakeTrimTarget(const MappedProgram& mapped,
                                  LivedEnvironments lived = {});

struct TrimTry {
  /// Nothing if some environment develops otherwise, or a test fails.
  std::optional<TrimTarget> target;
  std::uint64_t work = 0;  ///< symbols derived, about
};

/// With `genotype`, which lacks pieces of that kind, in place of the current.
TrimTry TryGenotype(const TrimTarget& target, Genotype genotype,
                    PieceKind kind);

}  // namespace plsc
