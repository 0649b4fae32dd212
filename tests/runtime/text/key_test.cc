#include "runtime/text/key.h"

#include <catch2/catch.hpp>
#include <set>
#include <string>

namespace plsc {

// Stores and caches are read by other versions and on other machines.
TEST_CASE("Keys are XXH3's published values", "[key]") {
  // xxHash 0.8, `xxhsum -H128` of nothing and of "abc".
  CHECK(Hex(KeyOf("")) == "99aa06d3014798d86001c324468d497f");
  CHECK(Hex(KeyOf("abc")) == "06b05ab6733a618578af5f94892f3950");
}

TEST_CASE("One bit more or less makes another key", "[key]") {
  const std::string content(100, 'a');
  std::set<Key> keys = {KeyOf(content)};
  for (std::size_t i = 0; i < content.size(); ++i)
    for (int bit = 0; bit < 8; ++bit) {
      std::string other = content;
      other[i] = static_cast<char>(other[i] ^ (1 << bit));
      keys.insert(KeyOf(other));
    }
  CHECK(keys.size() == 801);
  CHECK(Hex({1, 2}) == "00000000000000010000000000000002");
}

}  // namespace plsc
