#pragma once

// Commands that keep house among genotypes.

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/cli/arguments/output_format.h"
#include "runtime/cli/files/io.h"

namespace plsc::cli {

class Options;

/// Of the evolver's streams of random numbers (runtime/vary/rng.h): those of
/// the child that a run would bear then.
struct StreamChoice {
  std::uint64_t seed = 0;
  std::uint64_t generation = 0;
  std::uint64_t individual = 0;  ///< of the first child; the next has the next
};

struct CrossCommand {
  std::string first;  ///< whose states, settings and environments stay
  std::string second;
  StreamChoice stream;
  int count = 1;
  std::string experiment;  ///< empty: the paper's
  std::string output;      ///< empty: standard output
  bool force = false;      ///< as Output::force
  OutputFormat format = OutputFormat::kText;
  bool allow_range = false;
};
void Add(Options& options, CrossCommand& command);
Exit Run(const CrossCommand& command, Io& io);

struct HashCommand {
  std::vector<std::string> files;
  bool phenotype = false;  ///< of the developed robots, one an environment
  std::vector<std::string> environments;  ///< as DevelopCommand's
  bool allow_range = false;
};
void Add(Options& options, HashCommand& command);
Exit Run(const HashCommand& command, Io& io);

enum class ImportFormat : std::uint8_t { kAuto, kRepr, kLines };

struct ImportCommand {
  std::string file;
  ImportFormat from = ImportFormat::kAuto;
  std::string name;                  ///< of the genotype; empty: the file's
  std::vector<std::string> renames;  ///< "hill=inclined"
  std::string output;                ///< empty: standard output
  bool force = false;                ///< as Output::force
  bool unjoin = false;
  bool allow_range = false;
};
void Add(Options& options, ImportCommand& command);
Exit Run(const ImportCommand& command, Io& io);

struct MutateCommand {
  std::string file;
  StreamChoice stream;
  int count = 1;
  std::string experiment;  ///< empty: the paper's
  std::string output;      ///< empty: standard output
  bool force = false;      ///< as Output::force
  OutputFormat format = OutputFormat::kText;
  bool allow_range = false;
};
void Add(Options& options, MutateCommand& command);
Exit Run(const MutateCommand& command, Io& io);

struct StatsCommand {
  std::vector<std::string> files;
  std::vector<std::string> environments;  ///< as DevelopCommand's
  OutputFormat format = OutputFormat::kText;
  bool allow_range = false;
};
void Add(Options& options, StatsCommand& command);
Exit Run(const StatsCommand& command, Io& io);

struct TrimCommand {
  std::string file;
  bool write = false;  ///< in place
  std::string output;  ///< empty: standard output, unless `write`
  bool force = false;  ///< as Output::force
  bool check = false;
  std::string scenario;  ///< empty: every environment counts
  OutputFormat format = OutputFormat::kText;
  bool allow_range = false;
};
void Add(Options& options, TrimCommand& command);
Exit Run(const TrimCommand& command, Io& io);

}  // namespace plsc::cli
