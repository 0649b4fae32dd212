#include "grammar/enum_names.h"

#include <catch2/catch.hpp>
#include <cstdint>

namespace plsc {
namespace {

enum class Fruit : std::uint8_t { kApple, kPear };
constexpr EnumNames<Fruit, 2> kFruitNames{
    {{Fruit::kPear, "pear"}, {Fruit::kApple, "apple"}}};

TEST_CASE("A table of names is read both ways", "[enum_names]") {
  static_assert(NameIn(kFruitNames, Fruit::kApple) == "apple");
  for (const auto& [fruit, name] : kFruitNames) {
    CHECK(NameIn(kFruitNames, fruit) == name);
    CHECK(ValueIn(kFruitNames, name) == fruit);
  }
  CHECK_FALSE(ValueIn(kFruitNames, "apples"));
  CHECK_FALSE(ValueIn(kFruitNames, ""));
  CHECK(AllNames(kFruitNames) ==
        std::vector<std::string_view>{"pear", "apple"});
}

}  // namespace
}  // namespace plsc
