#include "grammar/keywords.h"

#include <catch2/catch.hpp>
#include <string>

namespace plsc {
namespace {

TEST_CASE("A name is an identifier that is no keyword", "[keywords]") {
  for (const char* name : {"C", "_", "A1", "move_ref_I", "Rule", "true", "x9"})
    CHECK(IsName(name));
  for (const char* other : {"", "9x", "a-b", "a b", "rule", "True", "then",
                            "include", "plsc", "\xC3\xA9"})
    CHECK_FALSE(IsName(other));
}

TEST_CASE("A genotype may have the name of a word that begins no item",
          "[keywords]") {
  for (const char* name : {"gecko", "test", "real", "True"})
    CHECK(IsGenotypeName(name));
  for (const char* other : {"", "9x", "a-b", "rule", "sense"})
    CHECK_FALSE(IsGenotypeName(other));
}

TEST_CASE("Every item keyword is a keyword", "[keywords]") {
  CHECK(ItemKeywords().size() == 13);
  for (const std::string_view word : ItemKeywords()) {
    CHECK(IsItemKeyword(word));
    CHECK(IsKeyword(word));
    CHECK_FALSE(IsKeyword(std::string(word) + "s"));
  }
  CHECK(IsKeyword("if"));
  CHECK_FALSE(IsItemKeyword("if"));
  CHECK_FALSE(IsItemKeyword(""));
}

TEST_CASE("Words that differ from a keyword in one letter are names",
          "[keywords]") {
  for (const char* keyword :
       {"False", "and", "or", "plsc", "replaceable", "environment"}) {
    const std::string word = keyword;
    CHECK(IsKeyword(word));
    CHECK_FALSE(IsKeyword(word.substr(1)));
    CHECK_FALSE(IsKeyword(word + word + word + word + word + word + word));
    for (std::size_t i = 0; i < word.size(); ++i)
      for (char c = 1; c < 127; ++c) {
        std::string other = word;
        other[i] = c;
        CAPTURE(other);
        REQUIRE(IsKeyword(other) == (other == word));
      }
  }
}

}  // namespace
}  // namespace plsc
