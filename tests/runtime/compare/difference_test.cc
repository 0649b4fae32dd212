#include "runtime/compare/difference.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

TEST_CASE("every kind of difference has its name and sentence",
          "[difference]") {
  CHECK(KindName(DifferenceKind::kMoved) == "moved");
  CHECK(Describe({DifferenceKind::kAdded, "edge a->b", "", ""}) ==
        "edge a->b added");
  CHECK(Describe(
            {DifferenceKind::kMoved, "module 7 (A1)", "x=1,y=0", "x=0,y=1"}) ==
        "module 7 (A1) moved: expected x=1,y=0, found x=0,y=1");
}

}  // namespace
}  // namespace plsc
