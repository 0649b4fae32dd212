#include "compiler/changes/merge_message.h"

#include <catch2/catch.hpp>

#include <vector>

namespace plsc {
namespace {

TEST_CASE("DescribeClash says what each side did", "[merge_message]") {
  using enum ClashKind;
  struct Row {
    ItemClash clash;
    const char* text;
  };
  const std::vector<Row> rows = {
      {{kBothChanged, "symbol 3", "T(1)", "T(2)", "T(3)"},
       "symbol 3: 'T(1)' is 'T(2)' in ours and 'T(3)' in theirs"},
      {{kDeletedAndChanged, "symbol 3", "T(1)", "", "T(3)"},
       "symbol 3: 'T(1)' is deleted in ours and 'T(3)' in theirs"},
      {{kBothInserted, "symbol 3", "", "B", "T(3)"},
       "symbol 3: 'B' is added in ours and 'T(3)' in theirs, at one place"},
      {{kBothInserted, "symbol 4", "", "", "T(3)"},
       "symbol 4: 'T(3)' is added in theirs, where ours adds something else"},
      {{kInsertedIntoDeleted, "symbol 3", "", "B", ""},
       "symbol 3: 'B' is added in ours between what theirs deletes"},
      {{kBothMoved, "symbol 3", "B", "B", "B"},
       "symbol 3: 'B' changes places with one symbol in ours and with another "
       "in theirs"},
      {{kAmbiguous, "symbol 3", "B", "B", "B"},
       "symbol 3: equal neighbours were changed, and the order of the merge "
       "cannot be told"},
      {{kBothChanged, "the comment", "", "", ""},
       "the comment: changed by both"},
      {{kBothChanged, "", "let a = 1", "let a = 2", "let a = 3"},
       "'let a = 1' is 'let a = 2' in ours and 'let a = 3' in theirs"},
  };
  for (const Row& row : rows)
    CHECK(DescribeClash(row.clash, MergeLabels()) == row.text);
  MergeLabels labels;
  labels.ours = "main";
  CHECK(DescribeClash(rows[1].clash, labels) ==
        "symbol 3: 'T(1)' is deleted in main and 'T(3)' in theirs");
}

}  // namespace
}  // namespace plsc
