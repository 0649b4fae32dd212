#pragma once

// One file checked, whatever kind it is of: what is wrong with it, or what it
// holds in a line for people.

#include <string>

#include "runtime/cli/arguments/texts.h"
#include "runtime/cli/files/io.h"
#include "runtime/cli/files/load_yaml.h"

namespace plsc::cli {

struct FileCheck {
  Findings findings;  ///< in it and in files that it names; may be warnings
  bool is_fine = false;
  /// "exp.yaml: experiment small, ..."; a line a genotype.
  std::string contents;
};

FileCheck CheckFile(const Source& source, const CheckCommand& command, Io& io);

}  // namespace plsc::cli
