#pragma once

// Leaves out of a genotype file what changes no robot: rules, symbols, and
// terms of clauses that decide nothing. Without them every environment that
// clauses tell apart (or that is lived in) develops into the very same body and
// brain, ids and every bit of every number included. Found by trying, big
// pieces first, each time by developing; so what is left out is never guessed.
// Comments and layout of the rest stay.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "compiler/compile.h"
#include "runtime/compare/same_robots.h"

namespace plsc {

struct TrimOptions {
  /// Index into CompileAll's programs; absent: all of the file. What belongs
  /// to other genotypes too only goes if it changes none of them.
  std::optional<std::size_t> only;
  /// By program, what it may develop in; empty: every environment that clauses
  /// tell apart. Where a robot never lives, it may become another one.
  std::vector<std::vector<NamedEnvironment>> lived;
  CompileOptions compile;
  /// Most symbols that are derived in trying, over all environments; beyond it
  /// what is found so far is the result. Random genotypes of the paper's kind
  /// take some 10^5; this is a few seconds.
  std::uint64_t max_work = std::uint64_t{1} << 25;
};

struct PieceCounts {
  std::size_t rules = 0;
  std::size_t terms = 0;
  std::size_t symbols = 0;
};

struct TrimmedGenotype {
  std::string name;
  PieceCounts before;
  PieceCounts after;
  std::vector<ComparedRegime> proof;  ///< before equals after in each
};

struct Trimmed {
  std::string text;
  std::vector<TrimmedGenotype> genotypes;  ///< all of the file
  bool is_complete = true;                 ///< false: `max_work` was used up
};

/// What the file expects of itself (`test` items) holds afterwards if it did
/// before. Trimming the result changes nothing if `is_complete`. Errors where
/// the text does not compile, where a string would outgrow its limit in some
/// environment (P4001), or where there are too many environments (W3005's
/// limit) to prove anything.
Result<Trimmed> Trim(const Source& source, const TrimOptions& options = {});

}  // namespace plsc
