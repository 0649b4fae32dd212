#pragma once

// A page that stays: an editor, its robot and its lives, joined with a file.

#include <optional>
#include <string>

#include "runtime/cli/files/io.h"

namespace plsc::cli {

class Options;

struct LiveCommand {
  std::string input;     ///< a genotype file, a run, a study's folder
  std::string scenario;  ///< of a genotype file; empty: the paper's
  int port = 0;          ///< 0: one that is free
  std::string host = "127.0.0.1";
  std::optional<int> jobs;  ///< processes that live robots; 0: one a core
  /// s without a page that is open after which it ends; nothing: never.
  std::optional<double> idle;
  bool open = false;  ///< in the browser, too
};
void Add(Options& options, LiveCommand& command);
Exit Run(const LiveCommand& command, Io& io);

}  // namespace plsc::cli
