#include "sim/state_hash.h"

#include <catch2/catch.hpp>
#include <cmath>

namespace plsc {
namespace {

std::uint64_t HashOf(std::initializer_list<double> numbers) {
  StateHash hash;
  for (const double number : numbers) hash.Add(number);
  return hash.value();
}

TEST_CASE("A hash tells any bit and any order apart", "[state_hash]") {
  CHECK(HashOf({}) == 0xcbf29ce484222325U);  // the published basis
  // FNV-1a of eight zero bytes, which is what 0.0 is made of.
  CHECK(HashOf({0.0}) == 0xa8c7f832281a39c5U);
  CHECK(HashOf({1, 2}) == HashOf({1, 2}));
  CHECK(HashOf({1, 2}) != HashOf({2, 1}));
  CHECK(HashOf({1}) != HashOf({std::nextafter(1, 2)}));
  CHECK(HashOf({0.0}) != HashOf({-0.0}));
}

}  // namespace
}  // namespace plsc
