#pragma once

// What an output may replace: one rule for all commands that write
// (docs/formats.md, "What an output replaces"), asked before the work that
// makes it and again when it is written.

#include <string>
#include <string_view>
#include <vector>

#include "runtime/cli/files/io.h"
#include "runtime/cli/files/output_mark.h"

namespace plsc::cli {

struct Output {
  std::string path;  ///< empty or "-": standard output
  OutputKind kind = OutputKind::kGenotype;
  bool force = false;  ///< replaces what it would not
  /// What the command reads, of which some may be no files.
  std::vector<std::string> inputs = {};
};

/// Whether the output can be written. Free are new names, empty files, pipes
/// and devices; a file with the mark of the output's kind is replaced, any
/// other with `force`. Never replaced are folders, the command's own inputs,
/// stores of runs, whatever their name (days of work, and a slip away in
/// `plsc report *.sqlite -o`), and links that lead nowhere. Prints what is
/// wrong.
bool CanWrite(const Output& output, Io& io);

/// Makes the folder of outputs, and those above it, unless it is there. Prints
/// what is wrong.
bool MakeFolder(const std::string& folder, Io& io);

/// Asks again and writes, as a whole or not at all. Prints what is wrong.
bool WriteOutput(const Output& output, std::string_view text, Io& io);

}  // namespace plsc::cli
