#include "runtime/text/scalar_place.h"

#include <catch2/catch.hpp>
#include <string>

namespace plsc {
namespace {

TEST_CASE("Parts of a scalar are found in the file", "[scalar_place]") {
  struct Row {
    const char* why;
    std::string file;
    std::string text;  // what the scalar means
    std::string part;
  };
  const Row rows[] = {
      {"plain", "f: speed - energy\n", "speed - energy", "energy"},
      {"in double quotes", "f: \"a ? bb : c\"\n", "a ? bb : c", "bb"},
      {"in single quotes", "f: 'a ? bb : c'\n", "a ? bb : c", "bb : c"},
      {"over two lines", "f: speed -\n   energy\n", "speed - energy", "energy"},
      {"a folded block", "f: >-\n  speed\n  - energy\n", "speed - energy",
       "- energy"},
      {"a literal block", "f: |  # why\n  speed\n  - energy\n",
       "speed\n- energy\n", "speed"},
  };
  for (const Row& row : rows) {
    INFO(row.why);
    const auto begin = static_cast<std::uint32_t>(row.text.find(row.part));
    const auto end = static_cast<std::uint32_t>(begin + row.part.size());
    const auto place = PlaceInScalar(row.file, 3, row.text, {begin, end});
    REQUIRE(place);
    CHECK(row.file.substr(place->begin, place->end - place->begin) == row.part);
  }
}

TEST_CASE("The end of a scalar is behind its last character",
          "[scalar_place]") {
  const std::string file = "f: \"a + \"\n";
  const auto place = PlaceInScalar(file, 3, "a + ", {4, 4});
  REQUIRE(place);
  CHECK(place->begin == 7);
  CHECK(place->end == 7);
}

TEST_CASE("What the file writes otherwise has no place", "[scalar_place]") {
  CHECK_FALSE(PlaceInScalar("f: \"\\x61 + b\"\n", 3, "a + b", {4, 5}));
  CHECK_FALSE(PlaceInScalar("f: a", 3, "a + b", {4, 5}));
}

}  // namespace
}  // namespace plsc
