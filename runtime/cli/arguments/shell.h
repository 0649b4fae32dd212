#pragma once

// Commands that shells and `man` want of plsc.

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/cli/files/io.h"

namespace plsc::cli {

class Options;

enum class Shell : std::uint8_t { kBash, kZsh, kFish };

struct CompletionCommand {
  Shell shell = Shell::kBash;
};
void Add(Options& options, CompletionCommand& command);
Exit Run(const CompletionCommand& command, Io& io);

struct ManCommand {
  std::vector<std::string> command;  ///< "study", "run"; empty: plsc itself
  std::string all;                   ///< a folder for all pages; empty: none
  bool force = false;                ///< as Output::force
};
void Add(Options& options, ManCommand& command);
Exit Run(const ManCommand& command, Io& io);

}  // namespace plsc::cli
