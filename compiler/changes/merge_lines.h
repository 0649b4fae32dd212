#pragma once

// Three versions of any text made into one by lines, as `diff3 -m` and `git
// merge-file` do: for versions that are no genotypes (a typo, another language,
// another kind of file), of which nothing may be lost all the same.

#include <string_view>

#include "compiler/changes/merge_program.h"

namespace plsc {

/// What one side alone changed is taken; where both changed neighbouring lines
/// in different ways stand git's markers, with the base. Every line without
/// conflict keeps its end.
MergedFile MergeLines(std::string_view base, std::string_view ours,
                      std::string_view theirs, const MergeLabels& labels = {});

}  // namespace plsc
