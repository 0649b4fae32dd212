#pragma once

// The canonical layout of a file that a person wrote: items in the order of
// Print and rules grouped as Print groups them, but comments, constants and
// the spelling of numbers are kept. Says nothing about meaning, and may not
// change it.

#include <string>

#include "compiler/compile.h"
#include "grammar/result.h"
#include "grammar/source.h"

namespace plsc {

struct FormatOptions {
  /// One group of symbols a line (a moving command ends a group) instead of
  /// one symbol a line: shorter to read, but two changes of one rule then
  /// conflict more often when merged.
  bool compact = false;
  CompileOptions compile;
};

/// The errors when the file does not compile. What is returned is checked: it
/// compiles to an equal Program, has all comments, and formats to itself. Its
/// lines end as the first line of the source does.
Result<std::string> Format(const Source& source,
                           const FormatOptions& options = {});

}  // namespace plsc
