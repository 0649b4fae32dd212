#pragma once

// `plsc relive`: robots of runs live again, to see what their records are
// worth.

#include <optional>
#include <string>
#include <vector>

#include "runtime/cli/arguments/output_format.h"
#include "runtime/cli/files/io.h"

namespace plsc::cli {

class Options;

struct ReliveCommand {
  std::vector<std::string> paths;    ///< folders of studies, runs
  std::string generations = "last";  ///< as ParseGenerations has it
  int lives = 20;
  int swaps = 5;
  bool engine_check = false;
  std::optional<int> jobs;
  bool quiet = false;
  OutputFormat format = OutputFormat::kText;
};
void Add(Options& options, ReliveCommand& command);
Exit Run(const ReliveCommand& command, Io& io);

}  // namespace plsc::cli
