#pragma once

// Commands that make robots of genotypes.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "runtime/cli/arguments/output_format.h"
#include "runtime/cli/files/io.h"
#include "sim/options.h"

namespace plsc::cli {

class Options;

struct DevelopCommand {
  std::string file;
  std::vector<std::string> environments;  ///< "a=True,b=False" or a name
  OutputFormat format = OutputFormat::kText;
  std::string svg_folder;  ///< empty: none
  bool force = false;      ///< as Output::force
  bool trace = false;
  bool allow_range = false;
};
void Add(Options& options, DevelopCommand& command);
Exit Run(const DevelopCommand& command, Io& io);

struct RandomCommand {
  std::optional<std::uint64_t> seed;  ///< without `experiment` there is one
  std::optional<int> count;           ///< absent: 1, or the population
  std::string experiment;             ///< a file instead of what follows
  std::string encoding = "plasticoding";
  std::vector<std::string> states{"inclined"};
  int max_groups = 4;
  int max_rules = 2;
  int max_terms = 2;
  std::string output;  ///< empty: standard output
  bool force = false;  ///< as Output::force
};
void Add(Options& options, RandomCommand& command);
Exit Run(const RandomCommand& command, Io& io);

struct RegulateCommand {
  std::string file;
  std::vector<std::string> environments;  ///< as in DevelopCommand
  bool table = false;
  OutputFormat format = OutputFormat::kText;
  bool allow_range = false;
};
void Add(Options& options, RegulateCommand& command);
Exit Run(const RegulateCommand& command, Io& io);

struct SimulateCommand {
  std::string file;                  ///< a genotype file, or the store of a run
  std::string individual;            ///< of a run: an id or "best"; else empty
  std::string scenario;              ///< empty: the run's, or the paper's
  std::optional<EngineKind> engine;  ///< of all seasons; nothing: as written
  OutputFormat format = OutputFormat::kText;
  std::string trajectory_folder;  ///< empty: none
  bool descriptors = false;       ///< all of them, text format only
  std::string record;             ///< a file; empty: none
  std::string svg;                ///< likewise
  bool force = false;             ///< as Output::force
};
void Add(Options& options, SimulateCommand& command);
Exit Run(const SimulateCommand& command, Io& io);

enum class TestFormat : std::uint8_t { kText, kJson, kJunit };

struct TestCommand {
  std::vector<std::string> paths;
  bool update = false;
  std::optional<int> jobs;
  TestFormat format = TestFormat::kText;
  std::string output;  ///< empty: standard output
  bool force = false;  ///< as Output::force
};
void Add(Options& options, TestCommand& command);
Exit Run(const TestCommand& command, Io& io);

struct WhyCommand {
  std::string file;        ///< or FILE:LINE:COLUMN, which asks about a symbol
  std::string individual;  ///< of a run: an id or "best"; else empty
  std::string module;      ///< an id to ask about; empty: none
  std::string node;
  std::string edge;
  std::vector<std::string> environments;  ///< as DevelopCommand's
  OutputFormat format = OutputFormat::kText;
  bool allow_range = false;
};
void Add(Options& options, WhyCommand& command);
Exit Run(const WhyCommand& command, Io& io);

}  // namespace plsc::cli
