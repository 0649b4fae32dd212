#include "grammar/number_error.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

SyntaxContext NumberAt(std::string_view text, std::uint32_t offset) {
  SyntaxContext context;
  context.text = text;
  context.offset = offset;
  return context;
}

TEST_CASE("A number that another language would take is corrected",
          "[number_error]") {
  struct Row {
    const char* text;
    const char* code;
    const char* right;
  };
  const std::vector<Row> rows = {
      {"+1.5", "P1110", "1.5"},   {".25", "P1110", "0.25"},
      {"-.25", "P1110", "-0.25"}, {"-inf", "P1111", nullptr},
      {"NaN", "P1111", nullptr},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.text) {
      const auto found = DescribeNumberLike(NumberAt(row.text, 0));
      REQUIRE(found);
      CHECK(NumberOf(found->code) == row.code);
      CHECK(found->fixes.empty() == (row.right == nullptr));
      if (row.right != nullptr) CHECK(found->fixes[0].replacement == row.right);
    }
  }
  CHECK_FALSE(DescribeNumberLike(NumberAt("name", 0)));
  CHECK_FALSE(DescribeNumberLike(NumberAt("-", 0)));
  CHECK_FALSE(DescribeNumberLike(NumberAt("", 0)));
}

TEST_CASE("A number that does not end is told why", "[number_error]") {
  CHECK(DescribeNumberEnd(NumberAt("-0x1F", 2)).code == Code::kForeignNumber);
  CHECK(DescribeNumberEnd(NumberAt("1_000", 1)).fixes[0].replacement == "1000");
  CHECK(DescribeNumberEnd(NumberAt("1.2.3", 3)).message ==
        "'1.2.3' has more than one '.'");
  CHECK(DescribeNumberEnd(NumberAt("2px", 1)).message ==
        "expected the number to end before 'px'");
  CHECK(DescribeMissingDigits(NumberAt("2.", 2)).label == "write '2.0' or '2'");
  CHECK(DescribeMissingDigits(NumberAt("2e+", 3)).message ==
        "expected digits after '+'");
}

TEST_CASE("Words for numbers that are not finite are known in any case",
          "[number_error]") {
  CHECK(IsNotFiniteWord("nan"));
  CHECK(IsNotFiniteWord("INF"));
  CHECK(IsNotFiniteWord("Infinity"));
  CHECK_FALSE(IsNotFiniteWord("info"));
}

}  // namespace
}  // namespace plsc
