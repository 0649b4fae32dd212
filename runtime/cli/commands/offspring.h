#pragma once

// What `plsc mutate` and `plsc cross` hand out: genotypes as one file, or one
// JSON object a line, and a line to people about each.

#include <string>
#include <vector>

#include "compiler/program.h"
#include "runtime/cli/arguments/output_format.h"
#include "runtime/cli/files/io.h"
#include "runtime/cli/files/output_path.h"

namespace plsc::cli {

/// Texts of one genotype each as the text of a file that holds them all, which
/// says its language once.
std::string JoinGenotypes(const std::vector<std::string>& texts);

struct OneChild {
  Program program;
  std::string told;  ///< "deleted a symbol of rule 3 (B)"
  std::string what;  ///< the same for scripts: a JSON object
};

/// What of Output::kind is written in that format.
OutputKind ChildrenKind(OutputFormat format);

/// Several genotypes get the numbers from 1 behind their names. Whether the
/// texts went where they were wanted; prints what is wrong.
bool DeliverChildren(std::vector<OneChild> children, const Output& output,
                     Io& io);

}  // namespace plsc::cli
