#pragma once

// Which tests `plsc test` paths mean: a genotype and the golden file beside
// it, `gecko.pls` and `gecko.golden.json`, found from either or from a folder.

#include <string>
#include <vector>

#include "runtime/cli/testing/case.h"

namespace plsc::cli {

struct FoundTests {
  std::vector<TestPaths> tests;      ///< each once, those of a folder sorted
  std::vector<TestedFile> problems;  ///< folders, each with one error
};

/// Folders are searched with all below them, but for hidden ones (.git) and
/// symbolic links to folders, which may lead in circles. A folder without any
/// test is a problem: a test run that tests nothing should not pass.
FoundTests FindTests(const std::vector<std::string>& paths);

}  // namespace plsc::cli
