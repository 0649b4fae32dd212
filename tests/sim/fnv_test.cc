#include "sim/fnv.h"

#include <catch2/catch.hpp>
#include <cmath>

namespace plsc {
namespace {

std::uint64_t HashOf(std::initializer_list<double> numbers) {
  Fnv hash;
  for (const double number : numbers) hash.Add(number);
  return hash.value();
}

TEST_CASE("A hash tells any bit and any order apart", "[fnv]") {
  CHECK(HashOf({}) == 0xcbf29ce484222325U);  // the published basis
  // FNV-1a of eight zero bytes, which is what 0.0 is made of.
  CHECK(HashOf({0.0}) == 0xa8c7f832281a39c5U);
  CHECK(HashOf({1, 2}) == HashOf({1, 2}));
  CHECK(HashOf({1, 2}) != HashOf({2, 1}));
  CHECK(HashOf({1}) != HashOf({std::nextafter(1, 2)}));
  CHECK(HashOf({0.0}) != HashOf({-0.0}));
}

TEST_CASE("A text is hashed byte by byte", "[fnv]") {
  Fnv hash;
  hash.Add("foo");
  hash.Add("bar");
  CHECK(hash.value() == 0x85944171f73967e8U);  // the authors' test vector
}

}  // namespace
}  // namespace plsc
