#pragma once

// Commands that make runs of evolution, and look at them.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "runtime/cli/arguments/output_format.h"
#include "runtime/cli/files/io.h"
#include "sim/options.h"

namespace plsc::cli {

class Options;

struct EvolveCommand {
  std::string experiment;  ///< empty: `resume` is not
  std::string output;      ///< likewise
  std::string resume;      ///< the store of a run to go on with
  bool or_resume = false;  ///< goes on if `output` exists
  std::string salvage;     ///< a damaged store to look simulations up in
  bool allow_other_version = false;
  std::optional<std::uint64_t> seed;
  std::optional<EngineKind> engine;  ///< of all seasons; nothing: as written
  std::optional<int> jobs;
  std::optional<double> hang_limit;  ///< s
  std::string cache;                 ///< a file; empty: none
  std::string json_log;              ///< a file or "-"; empty: none
  bool quiet = false;
  OutputFormat format = OutputFormat::kText;
};
void Add(Options& options, EvolveCommand& command);
Exit Run(const EvolveCommand& command, Io& io);

struct ShowCommand {
  std::string run;
  std::string individual;  ///< an id or "best"; empty: the run as a whole
  int lineage = 3;         ///< births back
  bool genotype = false;   ///< its text and nothing else
  bool verify = false;     ///< all of the run
  OutputFormat format = OutputFormat::kText;
};
void Add(Options& options, ShowCommand& command);
Exit Run(const ShowCommand& command, Io& io);

struct ReplayCommand {
  std::string run;
  std::vector<std::string> individuals;  ///< ids or "best"
  bool all = false;
  /// To compare it with the stored lives: of the survivors, unless others are
  /// named.
  std::optional<EngineKind> engine;
  std::optional<int> jobs;
  OutputFormat format = OutputFormat::kText;
};
void Add(Options& options, ReplayCommand& command);
Exit Run(const ReplayCommand& command, Io& io);

}  // namespace plsc::cli
