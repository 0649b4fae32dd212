#include "runtime/develop/part_names.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

TEST_CASE("parts have the names of the phenotype's files", "[part_names]") {
  CHECK(NodeName(0) == "node1");
  CHECK(EdgeName({2, 0, 0.5}) == "node3-node1");
  CHECK(SlotName(Slot::kBack) == "back");
  CHECK(SlotName(Slot::kFront) == "front");
  CHECK(SlotName(Slot::kRight) == "right");
  CHECK(SlotName(Slot::kLeft) == "left");
}

}  // namespace
}  // namespace plsc
