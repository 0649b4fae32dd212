#pragma once

// What a person is told of a clash: where, and what each side did.

#include <string>

#include "compiler/changes/merge_item.h"

namespace plsc {

/// How git, or the user, calls the versions.
struct MergeLabels {
  std::string base = "base";
  std::string ours = "ours";
  std::string theirs = "theirs";
  int marker_size = 7;  ///< characters of "<<<<<<<"; git's %L
};

/// "symbol 3: 'T(0.5)' is 'T(0.25)' in ours and deleted in theirs".
std::string DescribeClash(const ItemClash& clash, const MergeLabels& labels);

}  // namespace plsc
