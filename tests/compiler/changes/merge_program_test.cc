#include "compiler/changes/merge_program.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

MergedFile Merge(const std::string& base, const std::string& ours,
                 const std::string& theirs, const MergeLabels& labels = {}) {
  return MergeFiles(Source("base", base), Source("ours", ours),
                    Source("theirs", theirs), labels);
}

const std::string kHead = "plsc 1\nalphabet plasticoding 1\n";

TEST_CASE("MergeFiles merges items of both sides", "[merge_program]") {
  const MergedFile merged =
      Merge(kHead + "iterations 3\n", kHead + "iterations 4 # more\n",
            kHead +
                "sense hot: bool\niterations 3\n"
                "environment warm { hot = True }\n# end\n");
  CHECK(merged.conflicts.empty());
  CHECK(merged.text == kHead +
                           "sense hot: bool\niterations 4 # more\n"
                           "environment warm { hot = True }\n# end\n");
}

TEST_CASE("A conflict is around the smallest item", "[merge_program]") {
  MergeLabels labels{"old", "mine", "yours", 9};
  const MergedFile merged =
      Merge(kHead + "rule B -> { T(0.1) }\nlet a = 1\n",
            kHead + "rule B -> { T(0.2) }\nlet a = 1\n",
            kHead + "rule B -> { T(0.3) }\nlet a = 2\n", labels);
  CHECK(merged.text == kHead +
                           "<<<<<<<<< mine\nrule B -> { T(0.2) }\n"
                           "||||||||| old\nrule B -> { T(0.1) }\n"
                           "=========\nrule B -> { T(0.3) }\n"
                           ">>>>>>>>> yours\nlet a = 2\n");
  REQUIRE(merged.conflicts.size() == 1);
  CHECK(merged.conflicts[0].line == 3);
  CHECK(merged.conflicts[0].message ==
        "rule 1 of B: symbol 1: 'T(0.1)' is 'T(0.2)' in mine and 'T(0.3)' in "
        "yours");
}

TEST_CASE("A rule that one side deleted and the other changed is in conflict",
          "[merge_program]") {
  const MergedFile merged = Merge(kHead + "rule B -> { T(0.1) }\n", kHead,
                                  kHead + "rule B -> { T(0.3) }\n");
  REQUIRE(merged.conflicts.size() == 1);
  CHECK(merged.text == kHead +
                           "<<<<<<< ours\n||||||| base\nrule B -> { T(0.1) }\n"
                           "=======\nrule B -> { T(0.3) }\n>>>>>>> theirs\n");
}

TEST_CASE("Genotypes of a file are merged by their names", "[merge_program]") {
  const std::string a = "genotype a\niterations 2\n";
  const std::string b = "genotype b\niterations 2\n";
  SECTION("each side changes another") {
    const MergedFile merged =
        Merge(kHead + a + b, kHead + "genotype a\niterations 3\n" + b,
              kHead + a + "genotype b\niterations 4\n");
    CHECK(merged.conflicts.empty());
    CHECK(merged.text == kHead +
                             "genotype a\niterations 3\n"
                             "genotype b\niterations 4\n");
  }
  SECTION("one is added, one deleted") {
    const MergedFile merged =
        Merge(kHead + a + b, kHead + a + b + "genotype c\n", kHead + a);
    CHECK(merged.conflicts.empty());
    CHECK(merged.text == kHead + a + "genotype c\n");
  }
  SECTION("deleted and changed") {
    const MergedFile merged = Merge(kHead + a + b, kHead + a,
                                    kHead + a + "genotype b\niterations 4\n");
    REQUIRE(merged.conflicts.size() == 1);
    CHECK(merged.conflicts[0].message ==
          "genotype b: deleted in ours and 'changed' in theirs");
    CHECK(merged.text == kHead + a + "<<<<<<< ours\n||||||| base\n" + b +
                             "=======\ngenotype b\niterations 4\n"
                             ">>>>>>> theirs\n");
  }
}

TEST_CASE("Files that both sides added are merged from nothing",
          "[merge_program]") {
  const MergedFile merged =
      Merge("", kHead + "let b = 1\n", kHead + "let a = 1\n");
  CHECK(merged.conflicts.empty());
  CHECK(merged.text == kHead + "let a = 1\nlet b = 1\n");
}

TEST_CASE("Long files merge quickly enough to be tested", "[merge_program]") {
  std::string base = kHead;
  for (int i = 0; i < 3000; ++i)
    base += "rule B -> { T(0." + std::to_string(i + 1) + ") }\n";
  std::string ours = base;
  ours.replace(ours.find("T(0.10)"), 7, "T(0.5)");
  std::string theirs = base;
  theirs.replace(theirs.find("T(0.2990)"), 9, "T(0.7)");
  const MergedFile merged = Merge(base, ours, theirs);
  CHECK(merged.conflicts.empty());
  ours.replace(ours.find("T(0.2990)"), 9, "T(0.7)");
  CHECK(merged.text == ours);
}

}  // namespace
}  // namespace plsc
