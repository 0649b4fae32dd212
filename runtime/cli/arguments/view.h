#pragma once

// Pages that show robots.

#include <string>
#include <vector>

#include "runtime/cli/files/io.h"
#include "sim/options.h"

namespace plsc::cli {

class Options;

struct ViewCommand {
  /// Recordings, genotypes, stores of runs; a store is followed by the ids (or
  /// "best") of those of its robots that are meant.
  std::vector<std::string> inputs;
  std::string output;                ///< the page
  bool force = false;                ///< as Output::force
  std::string scenario;              ///< of genotypes; empty: the paper's
  std::optional<EngineKind> engine;  ///< of all seasons; nothing: as written
  bool editable = false;  ///< the page of `plsc live` as a file, of a genotype
  bool explain = false;   ///< the page of development instead, of genotypes
  std::vector<std::string> environments;  ///< of `explain`, as DevelopCommand's
  bool allow_range = false;
};
void Add(Options& options, ViewCommand& command);
Exit Run(const ViewCommand& command, Io& io);

}  // namespace plsc::cli
