#include "runtime/formula/quantities.h"

#include <catch2/catch.hpp>
#include <set>
#include <string>

#include "runtime/develop/descriptors.h"

namespace plsc {
namespace {

TEST_CASE("Quantities begin with all descriptors in their order", "[formula]") {
  std::vector<NamedValue> all = List(BodyDescriptors{});
  for (const auto& list : {List(BrainDescriptors{}), List(Behaviour{})})
    all.insert(all.end(), list.begin(), list.end());
  REQUIRE(all.size() < Quantities().size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const QuantityInfo& one = Quantities()[i];
    CHECK((one.column.empty() ? one.name : one.column) == all[i].name);
  }
}

TEST_CASE("Quantities are found by both names, and by no other", "[formula]") {
  std::set<std::string> names;
  for (std::size_t i = 0; i < Quantities().size(); ++i) {
    const QuantityInfo& one = Quantities()[i];
    CHECK(FindQuantity(one.name) == i);
    CHECK(names.insert(std::string(one.name)).second);
    CHECK_FALSE(one.meaning.empty());
    if (one.column.empty()) continue;
    CHECK(FindQuantity(one.column) == i);
    CHECK(names.insert(std::string(one.column)).second);
  }
  CHECK(QuantityNames().size() == names.size());
  CHECK_FALSE(FindQuantity(""));
  CHECK_FALSE(FindQuantity("sped"));
}

}  // namespace
}  // namespace plsc
