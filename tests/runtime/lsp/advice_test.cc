#include "runtime/lsp/advice.h"

#include <catch2/catch.hpp>

#include "runtime/advice/lint.h"
#include "tests/runtime/lsp/editor.h"

namespace plsc::lsp {

namespace {

int Rounds(Analysis& analysis, Advice* advice) {
  int rounds = 0;
  while (!advice->is_whole) {
    GiveMoreAdvice(analysis, advice);
    ++rounds;
  }
  return rounds;
}

}  // namespace

TEST_CASE("Advice is Lint's, a genotype at a time", "[lsp]") {
  const std::string text =
      "plsc 1\nalphabet plasticoding 1\nsense a: bool\n"
      "genotype one\nrule C -> if a = True then { C loop(0.5) }\n"
      "genotype two\n# plsc: allow W3003\n"
      "rule C -> if a = True then { C B }\n"
      "genotype three\nrule C -> { C add_edge(0.5) }\n";
  Analysis analysis(kTestUri, text);
  Advice advice;
  CHECK(Rounds(analysis, &advice) == 3);
  const auto expected = Lint(*analysis.compiled(), analysis.source());
  REQUIRE(advice.found.size() == expected.size());
  REQUIRE(expected.size() >= 3);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    CHECK(advice.found[i].code == expected[i].code);
    CHECK(advice.found[i].span == expected[i].span);
  }
}

TEST_CASE("There is no advice on broken texts", "[lsp]") {
  Analysis analysis(kTestUri, "plsc 1\nrule");
  Advice advice;
  CHECK(Rounds(analysis, &advice) == 1);
  CHECK(advice.found.empty());
}

}  // namespace plsc::lsp
