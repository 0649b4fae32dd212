#pragma once

// One item in three versions, made into one: of rules the clause term by term
// and the production symbol by symbol, of environments the entries, of inline
// tests the symbols; of all others the whole.

#include <optional>
#include <string>
#include <vector>

#include "compiler/changes/merge_parts.h"
#include "compiler/changes/written_items.h"

namespace plsc {

/// nullptr: the version has no such item. Two at least are there.
struct ItemVersions {
  const WrittenItem* base = nullptr;
  const WrittenItem* ours = nullptr;
  const WrittenItem* theirs = nullptr;
};

/// Why they cannot be one; `what` as in "symbol 3", empty for the whole item.
/// Texts are empty of what is not there.
struct ItemClash {
  ClashKind kind = ClashKind::kBothChanged;
  std::string what;
  std::string base;
  std::string ours;
  std::string theirs;
};

/// With clashes the texts are not to be used.
struct MergedItem {
  std::string before;
  std::string core;  ///< the item itself
  std::string after;
  std::vector<ItemClash> clashes;
};

/// Of an item that both sides have.
MergedItem MergeItem(const ItemVersions& versions);

/// Whether they say the same; comments and layout do not count.
bool SameContent(const WrittenItem& a, const WrittenItem& b);

}  // namespace plsc
