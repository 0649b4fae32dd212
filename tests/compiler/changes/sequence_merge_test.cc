#include "compiler/changes/sequence_merge.h"

#include <catch2/catch.hpp>

#include <string>

#include "tests/compiler/changes/merge_rows.h"

namespace plsc {
namespace {

using test::LetterCosts;
using test::Letters;

char Letter(const std::string& text, int index) {
  return index == kNoElement ? '-' : text[static_cast<std::size_t>(index)];
}

// What a merge comes to; "!" and the number of the ClashKind at a clash.
std::string Merged(const std::string& base, const std::string& ours,
                   const std::string& theirs) {
  const SequenceMerge merge =
      MergeSequences({Letters(base), Letters(ours), Letters(theirs)},
                     LetterCosts(base, ours), LetterCosts(base, theirs));
  std::string text;
  for (const MergedElement& element : merge) {
    const char b = Letter(base, element.base);
    const char o = Letter(ours, element.ours);
    const char t = Letter(theirs, element.theirs);
    if (element.clash)
      text += '!' + std::to_string(static_cast<int>(*element.clash));
    else if (element.base == kNoElement)
      text += o != '-' ? o : t;
    else
      text += o == b ? t : t == b || t == o ? o : '?';
  }
  return text;
}

TEST_CASE("MergeSequences does what both sides did", "[sequence_merge]") {
  const std::vector<test::MergeRow> rows = {
      {"one side only", "abc", "axc", "abc", "axc"},
      {"both the same", "abc", "axc", "axc", "axc"},
      {"both the same of equals", "abbc", "abc", "abc", "abc"},
      {"far apart", "abcdef", "xbcdef", "abcdex", "xbcdex"},
      {"neighbours", "abcd", "axcd", "abyd", "axyd"},
      {"a deletion beside an insertion", "abcd", "acd", "abxcd", "axcd"},
      {"and before it", "abcd", "acd", "axbcd", "axcd"},
      {"deletions of neighbours", "abcd", "acd", "abd", "ad"},
      {"insertions around one", "abc", "axbc", "abyc", "axbyc"},
      {"the same insertion", "abc", "axbc", "axbc", "axbc"},
      {"a swap and a deletion between", "abcde", "adcbe", "abde", "adbe"},
      {"a swap and a deletion of one of them", "abcde", "adcbe", "acde",
       "adce"},
      {"a swap and a change of one of them", "abcde", "adcbe", "axcde",
       "adcxe"},
      {"a swap and an insertion between", "abc", "acb", "abxc", "acxb"},
      {"two swaps", "abcdef", "bacdef", "abcdfe", "bacdfe"},
      {"the same swap", "abcdef", "bacdef", "bacdef", "bacdef"},
  };
  test::CheckMerges(rows,
                    [](const char* base, const char* ours, const char* theirs) {
                      const std::string merged = Merged(base, ours, theirs);
                      CHECK(Merged(base, theirs, ours) == merged);
                      return merged;
                    });
}

TEST_CASE("MergeSequences finds where sides clash", "[sequence_merge]") {
  struct Row {
    const char* why;
    const char* base;
    const char* ours;
    const char* theirs;
    ClashKind clash;
  };
  const std::vector<Row> rows = {
      {"two insertions", "ab", "axb", "ayb", ClashKind::kBothInserted},
      {"one begins like the other", "ab", "axb", "axyb",
       ClashKind::kBothInserted},
      {"deleted and changed", "abc", "ac", "axc",
       ClashKind::kDeletedAndChanged},
      {"into what is deleted", "abcd", "ad", "abxcd",
       ClashKind::kInsertedIntoDeleted},
      {"two swaps of one", "abcd", "bacd", "acbd", ClashKind::kBothMoved},
      {"between equals of which one goes", "abbc", "abc", "abxbc",
       ClashKind::kAmbiguous},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const std::string mark =
          '!' + std::to_string(static_cast<int>(row.clash));
      CHECK(Merged(row.base, row.ours, row.theirs).find(mark) !=
            std::string::npos);
      CHECK(Merged(row.base, row.theirs, row.ours).find(mark) !=
            std::string::npos);
    }
  }
}

TEST_CASE("MergeEdits takes one choice of edits", "[sequence_merge]") {
  const SequenceVersions versions{{1, 2}, {1}, {1, 2}};
  const SequenceEdit ours{{0, kNoElement}, {{}, {}, {}}, {}};
  const SequenceEdit theirs{{0, 1}, {{}, {}, {}}, {}};
  CHECK(MergeEdits(versions, ours, theirs) ==
        SequenceMerge{{0, 0, 0, std::nullopt}});
}

}  // namespace
}  // namespace plsc
