// PEGTL's analysis finds rules that could loop without consuming anything.

#include <catch2/catch.hpp>
#include <tao/pegtl/contrib/analyze.hpp>

#include "grammar/recover.h"

namespace plsc {
namespace {

TEST_CASE("No rule of the grammar can loop without progress", "[analyze]") {
  CHECK(tao::pegtl::analyze<grammar::file>(1) == 0);
}

}  // namespace
}  // namespace plsc
