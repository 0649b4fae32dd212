#pragma once

// Commands that look at genotypes as texts.

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/cli/arguments/output_format.h"
#include "runtime/cli/files/io.h"

namespace plsc::cli {

class Options;

enum class CheckFormat : std::uint8_t { kText, kJson, kSarif, kGithub };

struct CheckCommand {
  std::vector<std::string> files;
  CheckFormat format = CheckFormat::kText;
  bool allow_range = false;
  bool lint = false;
  ColorChoice color = ColorChoice::kAuto;
  int max_errors = 20;  ///< a file, text format only; 0 shows all
};
void Add(Options& options, CheckCommand& command);
Exit Run(const CheckCommand& command, Io& io);

struct ExplainCommand {
  std::string code;
  bool list = false;
  OutputFormat format = OutputFormat::kText;
};
void Add(Options& options, ExplainCommand& command);
Exit Run(const ExplainCommand& command, Io& io);

struct FixCommand {
  std::vector<std::string> files;
  bool check = false;
  bool diff = false;
  bool allow_range = false;
};
void Add(Options& options, FixCommand& command);
Exit Run(const FixCommand& command, Io& io);

struct FmtCommand {
  std::vector<std::string> files;
  bool check = false;
  bool diff = false;
  bool to_stdout = false;
  bool compact = false;
};
void Add(Options& options, FmtCommand& command);
Exit Run(const FmtCommand& command, Io& io);

struct LintCommand {
  std::vector<std::string> files;
  OutputFormat format = OutputFormat::kText;
  bool deny = false;
  bool allow_range = false;
};
void Add(Options& options, LintCommand& command);
Exit Run(const LintCommand& command, Io& io);

}  // namespace plsc::cli
