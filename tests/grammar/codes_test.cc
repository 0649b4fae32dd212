#include "grammar/codes.h"

#include <algorithm>
#include <catch2/catch.hpp>

namespace plsc {
namespace {

TEST_CASE("Codes are sorted, unique and explained", "[codes]") {
  const auto codes = DiagnosticCodes();
  CHECK(std::is_sorted(
      codes.begin(), codes.end(),
      [](const CodeInfo& a, const CodeInfo& b) { return a.code < b.code; }));
  CHECK(std::adjacent_find(codes.begin(), codes.end(),
                           [](const CodeInfo& a, const CodeInfo& b) {
                             return a.code == b.code;
                           }) == codes.end());
  for (const CodeInfo& info : codes) {
    CHECK(info.code.size() == 5);
    CHECK(MeaningOf(info.code) == info.meaning);
    CHECK_FALSE(info.meaning.empty());
  }
  CHECK(MeaningOf("P9999").empty());
}

}  // namespace
}  // namespace plsc
