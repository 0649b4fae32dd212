#include "runtime/text/aligned_rows.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

TEST_CASE("Columns are as wide as their widest cell", "[aligned_rows]") {
  CHECK(AlignedRows({}).empty());
  CHECK(AlignedRows({{"a", "bb"}, {"ccc", "d"}, {"e"}, {"", "", "f"}}) ==
        "a    bb\nccc  d\ne\n         f\n");
  CHECK(AlignedRows({{"", ""}}) == "\n");
}

}  // namespace
}  // namespace plsc
