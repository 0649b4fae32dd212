#pragma once

// Commands that compare and merge versions of genotypes, by hand or for git.

#include <string>
#include <vector>

#include "runtime/cli/arguments/output_format.h"
#include "runtime/cli/files/io.h"

namespace plsc::cli {

class Options;

struct DiffCommand {
  /// OLD and NEW; what git passes to an external diff with `is_git`.
  std::vector<std::string> files;
  bool is_git = false;
  std::vector<std::string> environments;  ///< as DevelopCommand's
  OutputFormat format = OutputFormat::kText;
  ColorChoice color = ColorChoice::kAuto;
  bool allow_range = false;
};
void Add(Options& options, DiffCommand& command);
Exit Run(const DiffCommand& command, Io& io);

struct MergeCommand {
  std::string base;
  std::string ours;
  std::string theirs;
  std::string output;               ///< empty: standard output
  bool force = false;               ///< as Output::force
  bool write_ours = false;          ///< instead
  bool is_driver = false;           ///< likewise, as git wants it
  int marker_size = 7;              ///< characters of a conflict marker
  std::string path;                 ///< git's name of the file; empty: `ours`
  std::vector<std::string> labels;  ///< of ours, base, theirs
  bool allow_range = false;
};
void Add(Options& options, MergeCommand& command);
Exit Run(const MergeCommand& command, Io& io);

}  // namespace plsc::cli
