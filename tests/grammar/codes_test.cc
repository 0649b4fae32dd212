#include "grammar/codes.h"

#include <algorithm>
#include <catch2/catch.hpp>

namespace plsc {
namespace {

TEST_CASE("Codes are sorted, unique and explained", "[codes]") {
  const auto codes = DiagnosticCodes();
  CHECK(std::is_sorted(codes.begin(), codes.end(),
                       [](const CodeInfo& a, const CodeInfo& b) {
                         return a.number < b.number;
                       }));
  CHECK(std::adjacent_find(codes.begin(), codes.end(),
                           [](const CodeInfo& a, const CodeInfo& b) {
                             return a.number == b.number;
                           }) == codes.end());
  for (const CodeInfo& info : codes) {
    CHECK(info.number.size() == 5);
    CHECK(NumberOf(info.code) == info.number);
    CHECK(MeaningOf(info.code) == info.meaning);
    CHECK(FindCode(info.number) == info.code);
    CHECK_FALSE(info.meaning.empty());
  }
  CHECK_FALSE(FindCode("P9999"));
  CHECK_FALSE(FindCode(""));
}

TEST_CASE("Defects of plsc have numbers that nobody can ask for", "[codes]") {
  CHECK(NumberOf(Code::kParserDefect) == "P1199");
  CHECK(NumberOf(Code::kFormatterDefect) == "P5090");
  CHECK_FALSE(FindCode("P1199"));
  CHECK_FALSE(FindCode("P5090"));
}

}  // namespace
}  // namespace plsc
