// The bits of sim/maths are fixed for ever, whatever compiles them.

#include <catch2/catch.hpp>

#include "tests/sim/maths/maths_hash.h"

namespace plsc_optimised {
std::uint64_t HashOfMaths();
}
namespace plsc_unoptimised {
std::uint64_t HashOfMaths();
}

namespace plsc {
namespace {

TEST_CASE("The bits of all functions are those on file", "[maths]") {
  CHECK(test::MathsHash() == test::kMathsHash);
}

TEST_CASE("Optimisation changes no bit of the functions", "[maths]") {
  CHECK(plsc_unoptimised::HashOfMaths() == test::kMathsHash);
  CHECK(plsc_optimised::HashOfMaths() == test::kMathsHash);
}

}  // namespace
}  // namespace plsc
