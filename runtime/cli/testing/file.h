#pragma once

// Tests one genotype against its golden file: reads both, develops in every
// environment, compares. Prints and writes nothing, so that threads may run it
// side by side.

#include <optional>
#include <string>

#include "runtime/cli/testing/case.h"

namespace plsc::cli {

struct TestOutcome {
  TestedFile tested;
  /// With `update`, the text that the golden file should have, when it is not
  /// what it has. The cases then say kUpdated where something changes.
  std::optional<std::string> new_golden;
};

/// With `update`, a file with a case of kError is left as it is: what cannot
/// be developed cannot be recorded, and a golden file that cannot be read may
/// hold environments that somebody wrote.
TestOutcome TestFile(const TestPaths& paths, bool update);

}  // namespace plsc::cli
