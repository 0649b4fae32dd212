#include "runtime/authors/cursor.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

TEST_CASE("A cursor takes what is there, and remembers its first error",
          "[authors_cursor]") {
  AuthorsCursor cursor(" [ 'hill' , 2.5 ]");
  CHECK(cursor.Want("[", "first"));
  CHECK_FALSE(cursor.Take("]"));
  CHECK(cursor.Want("'", "then"));
  const auto word = cursor.Until("'", "a word");
  REQUIRE(word);
  CHECK(cursor.Text(*word) == "hill");
  CHECK(cursor.Want("'", "then"));
  CHECK(cursor.Want(",", "then"));
  CHECK(cursor.Number()->value == 2.5);
  CHECK_FALSE(cursor.Want("}", "at the end"));
  REQUIRE(cursor.error());
  CHECK(cursor.error()->message == "'}' at the end is expected, not ']'");
  CHECK(cursor.error()->span == Span{16, 17});
  CHECK_FALSE(cursor.Take("]"));
  CHECK_FALSE(cursor.Number());
  CHECK(cursor.error()->span == Span{16, 17});
}

}  // namespace
}  // namespace plsc
