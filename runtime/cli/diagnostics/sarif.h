#pragma once

// Diagnostics as SARIF 2.1.0 (OASIS), the format in which code scanners of
// hosting sites and editors exchange results. Made from the same structure as
// the text and the JSON lines.

#include <string>
#include <vector>

#include "grammar/diagnostic.h"

namespace plsc::cli {

/// A file and what was found in it. An unreadable file has an empty text.
struct CheckedFile {
  Source source;
  std::vector<Diagnostic> diagnostics;
};

/// One document: one run with a rule for each code that was found, and a
/// result for each diagnostic. Columns count Unicode code points from 1; the
/// end of a region is one past its last character.
std::string Sarif(const std::vector<CheckedFile>& files);

}  // namespace plsc::cli
