#pragma once

// `plsc report`: what studies and runs say.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "runtime/cli/files/io.h"

namespace plsc::cli {

class Options;

enum class ReportFormat : std::uint8_t {
  kHtml,
  kJson,
  kText,   ///< of the claims alone
  kFiles,  ///< a folder of tables and figures
};

struct ReportCommand {
  std::vector<std::string> paths;  ///< folders of studies, runs
  std::string output;              ///< empty: standard output, kJson, kText
  bool force = false;              ///< as Output::force
  std::string measures = "paper";
  ReportFormat format = ReportFormat::kHtml;
  bool verify = false;
  std::optional<int> check_engine;  ///< best robots of a run to live anew
  std::optional<int> relive;        ///< lives of survivors, made first
  bool quiet = false;
};
void Add(Options& options, ReportCommand& command);
Exit Run(const ReportCommand& command, Io& io);

}  // namespace plsc::cli
