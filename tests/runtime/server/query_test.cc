#include "runtime/server/query.h"

#include <catch2/catch.hpp>

namespace plsc::server {
namespace {

TEST_CASE("values of an address are found and decoded", "[query]") {
  CHECK(QueryValue("run=plastic%2F3&id=17", "run") == "plastic/3");
  CHECK(QueryValue("run=plastic%2f3&id=17", "id") == "17");
  CHECK(QueryValue("a=b+c", "a") == "b c");
  CHECK(QueryValue("a=", "a") == "");
  CHECK(QueryValue("a=1&a=2", "a") == "1");
  CHECK(QueryValue("a=b=c", "a") == "b=c");
}

TEST_CASE("what is not there, or no text, is nothing", "[query]") {
  const std::string query = GENERATE("", "a", "&", "=", "b=1", "aa=1", "%61=1",
                                     "a=%", "a=%4", "a=%zz", "&&&&");
  CAPTURE(query);
  CHECK_FALSE(QueryValue(query, "a"));
}

}  // namespace
}  // namespace plsc::server
