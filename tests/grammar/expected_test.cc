#include "grammar/expected.h"

#include <catch2/catch.hpp>
#include <memory>

#include "grammar/failure.h"

namespace plsc {
namespace {

TEST_CASE("There is a value or the reason why there is none", "[expected]") {
  const Expected<int, Failure> value = 0;
  REQUIRE(value);
  CHECK(*value == 0);
  const Expected<int, Failure> none =
      Failure("it is full", Failure::Kind::kChanged);
  REQUIRE_FALSE(none);
  CHECK(none.error().text == "it is full");
  CHECK(none.error().kind == Failure::Kind::kChanged);
}

TEST_CASE("A value that was found may be moved out", "[expected]") {
  Expected<std::unique_ptr<int>, Failure> found = std::make_unique<int>(3);
  REQUIRE(found);
  CHECK(**found == 3);
  const std::unique_ptr<int> taken = std::move(*found);
  CHECK(*taken == 3);
}

}  // namespace
}  // namespace plsc
