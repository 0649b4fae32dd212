#pragma once

// `plsc study` and its commands: many runs that one file describes.

#include <optional>
#include <string>

#include "runtime/cli/arguments/output_format.h"
#include "runtime/cli/files/io.h"
#include "sim/options.h"

namespace plsc::cli {

class Options;

struct StudyListCommand {
  std::string study;
  std::string only;   ///< as StudyRunCommand's
  std::string shard;  ///< likewise
  OutputFormat format = OutputFormat::kText;
};
void Add(Options& options, StudyListCommand& command);
Exit Run(const StudyListCommand& command, Io& io);

struct StudyRunCommand {
  std::string study;
  std::string output;                ///< the study's folder
  std::string only;                  ///< "plastic" or "plastic/3"; empty: all
  std::string shard;                 ///< "2/8", well formed; empty: all
  std::optional<EngineKind> engine;  ///< of all seasons; nothing: as written
  std::optional<int> jobs;           ///< of every run
  std::string cache;                 ///< a file; empty: none
  bool allow_other_version = false;
  bool quiet = false;
};
void Add(Options& options, StudyRunCommand& command);
Exit Run(const StudyRunCommand& command, Io& io);

struct StudyStatusCommand {
  std::string folder;
  OutputFormat format = OutputFormat::kText;
};
void Add(Options& options, StudyStatusCommand& command);
Exit Run(const StudyStatusCommand& command, Io& io);

struct StudyDigestCommand {
  std::string folder;
  std::string output;    ///< a digest, which takes what is new
  std::string measures;  ///< as ReportCommand's; empty: as the digest has them
  bool force = false;
  std::optional<int> every;  ///< generations; nothing: as the digest has it
  bool quiet = false;
};
void Add(Options& options, StudyDigestCommand& command);
Exit Run(const StudyDigestCommand& command, Io& io);

}  // namespace plsc::cli
