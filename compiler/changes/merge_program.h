#pragma once

// Three versions of a genotype file made into one, by what they say and not by
// lines: items by their names, rules by what they are, symbols, terms and
// arguments one by one. Comments and layout of both sides come along. A text of
// both sides' items may still be wrong (one side uses what the other removed);
// who writes it compiles it.

#include <string>
#include <vector>

#include "compiler/changes/merge_message.h"
#include "grammar/source.h"

namespace plsc {

struct MergeConflict {
  int line = 0;         ///< of the text, where its markers begin
  std::string message;  ///< "rule 2 of C: symbol 3: ..."
};

/// With conflicts, the text has git's markers (with the base, as diff3 style)
/// around each item that is in conflict.
struct MergedFile {
  std::string text;
  std::vector<MergeConflict> conflicts;
};

/// `ours` and `theirs` compile; `base` does, or is empty (both added the file).
MergedFile MergeFiles(const Source& base, const Source& ours,
                      const Source& theirs, const MergeLabels& labels = {});

}  // namespace plsc
