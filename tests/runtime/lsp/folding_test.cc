#include "runtime/lsp/folding.h"

#include <catch2/catch.hpp>
#include <vector>

#include "tests/runtime/lsp/editor.h"

namespace plsc::lsp {

namespace {

struct Lines {
  int first = 0;
  int last = 0;
  bool is_comment = false;
  friend bool operator==(const Lines&, const Lines&) = default;
};

std::vector<Lines> Folds(const std::string& text) {
  Analysis analysis(kTestUri, text);
  std::vector<Lines> folds;
  for (const Json& one : FoldingRanges(analysis))
    folds.push_back(
        {one["startLine"], one["endLine"], one.value("kind", "") == "comment"});
  return folds;
}

}  // namespace

TEST_CASE("Items of several lines fold, their last brace stays", "[lsp]") {
  CHECK(Folds(kGecko) == std::vector<Lines>{{10, 13}, {15, 18}});
  CHECK(Folds("plsc 1\nrule C -> {\n  C }\n") == std::vector<Lines>{{1, 2}});
  CHECK(Folds("plsc 1\nrule B -> if a = True\n then { B }\n") ==
        std::vector<Lines>{{1, 2}});
  CHECK(Folds("plsc 1\r\nrule C -> {\r\n  C\r\n}\r\n") ==
        std::vector<Lines>{{1, 2}});
}

TEST_CASE("Genotypes of a file with several fold", "[lsp]") {
  const std::string text =
      "plsc 1\nalphabet plasticoding 1\n\ngenotype a\nrule C -> { C }\n\n"
      "# next\ngenotype b\nrule C -> {\n  C\n}\n";
  CHECK(Folds(text) == std::vector<Lines>{{3, 4}, {7, 10}, {8, 9}});
}

TEST_CASE("Comments on lines of their own fold together", "[lsp]") {
  CHECK(Folds("# a\n# b\n\n# c\nplsc 1 # d\n# e\n  # f\n# g\n") ==
        std::vector<Lines>{{0, 1, true}, {5, 7, true}});
  CHECK(Folds("").empty());
  // What does not parse folds as far as it does.
  CHECK(Folds("plsc 1\nrule C -> {\n  C\n\nrule B -> {\n  B\n}\n") ==
        std::vector<Lines>{{4, 5}});
}

}  // namespace plsc::lsp
