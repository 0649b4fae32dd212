#pragma once

// Tables of merges: what three versions come to, told in texts.

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "compiler/changes/sequence_edit.h"

namespace plsc::test {

struct MergeRow {
  const char* why;
  const char* base;
  const char* ours;
  const char* theirs;
  const char* merged;
};

/// `merge` takes base, ours and theirs, and returns the text that they come to.
template <typename Merge>
void CheckMerges(const std::vector<MergeRow>& rows, const Merge& merge) {
  for (const MergeRow& row : rows) {
    DYNAMIC_SECTION(row.why) {
      CHECK(merge(row.base, row.ours, row.theirs) == row.merged);
    }
  }
}

/// Texts as sequences of letters: to become another costs less than to go and
/// to come.
inline EditCosts LetterCosts(const std::string& from, const std::string& to) {
  return {12, [from, to](std::size_t i, std::size_t j) {
            return from[i] == to[j] ? 0 : 10;
          }};
}

inline std::vector<int> Letters(const std::string& text) {
  return {text.begin(), text.end()};
}

}  // namespace plsc::test
