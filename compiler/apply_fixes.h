#pragma once

// Mending a text by the fixes that its own diagnostics offer: what `plsc fix`
// does, without its files. A fix may uncover errors that it hid, so that the
// text is compiled again until nothing more can be mended.

#include <string>
#include <vector>

#include "compiler/compile.h"

namespace plsc {

/// What was mended, as it was found.
struct MadeFix {
  Position position;        ///< in the text of that round
  Code code;                ///< of the diagnostic
  std::string removed;      ///< empty for an insertion
  std::string replacement;  ///< empty for a deletion
  /// What else to know of it, such as that arguments have another order.
  std::string note;
};

struct MendedText {
  std::string text;
  std::vector<MadeFix> made;  ///< in the order in which they were made
  /// What is still wrong with `text`, and its warnings.
  std::vector<Diagnostic> remaining;
};

/// The text with the fixes of some diagnostics made: all that do not touch
/// each other, those that come first in the text preferred. The changes of one
/// diagnostic are made together or not at all.
MendedText ApplyFixes(const Source& source,
                      const std::vector<Diagnostic>& diagnostics);

/// Compiles and applies until nothing more can be mended. Never has more
/// errors than `source`; equal to it when no fix helps.
MendedText MendText(const Source& source, const CompileOptions& options = {});

}  // namespace plsc
