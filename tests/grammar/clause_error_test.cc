#include "grammar/clause_error.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

SyntaxContext At(std::string_view text, std::uint32_t offset) {
  SyntaxContext context;
  context.text = text;
  context.offset = offset;
  context.previous_end = offset;
  while (context.previous_end > 0 && text[context.previous_end - 1] == ' ')
    --context.previous_end;
  return context;
}

TEST_CASE("All foreign words of a clause are corrected at once",
          "[clause_error]") {
  const auto found = DescribeForeign(SyntaxError::kComparison,
                                     At("a == true && b = FALSE {", 2));
  REQUIRE(found);
  CHECK(found->code == Code::kForeignNotation);
  REQUIRE(found->fixes.size() == 4);
  CHECK(found->fixes[0].replacement == "=");
  CHECK(found->fixes[1].replacement == "True");
  CHECK(found->fixes[2].replacement == "and");
  CHECK(found->fixes[3].replacement == "False");
}

TEST_CASE("An operator of which the grammar took half is seen as a whole",
          "[clause_error]") {
  const auto found =
      DescribeForeign(SyntaxError::kTermValue, At("a <> True", 3));
  REQUIRE(found);
  CHECK(found->span == Span{2, 4});
  CHECK(found->fixes[0].replacement == "!=");
}

TEST_CASE("A missing comparison is written as it may be meant",
          "[clause_error]") {
  CHECK(DescribeMissingComparison(At("hot then", 4)).help ==
        "write 'hot = True'");
  CHECK(DescribeMissingComparison(At("hot False", 4)).help ==
        "write 'hot = False'");
  CHECK(DescribeMissingComparison(At("hot 5", 4)).help.empty());
}

TEST_CASE("A missing then is inserted before the brace", "[clause_error]") {
  const Diagnostic found = DescribeMissingThen(At("hot = True {", 11));
  REQUIRE(found.fixes.size() == 1);
  CHECK(found.fixes[0].replacement == "then ");
  CHECK(DescribeMissingThen(At("hot = True B", 11)).fixes.empty());
}

}  // namespace
}  // namespace plsc
