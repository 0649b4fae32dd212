#include "sim/body.h"

#include <catch2/catch.hpp>

#include "tests/sim/bodies.h"

namespace plsc {
namespace {

TEST_CASE("Modules are named by number, sensors by where they sit", "[body]") {
  Body body = LoneCore();
  const int brick = Mount(body, 0, Slot::kLeft, ModuleType::kBrick);
  const int on_core = Mount(body, 0, Slot::kBack, ModuleType::kTouchSensor);
  const int on_brick =
      Mount(body, brick, Slot::kRight, ModuleType::kTouchSensor);
  CHECK(ModuleId(body, 0) == "1");
  CHECK(ModuleId(body, brick) == "2");
  CHECK(ModuleId(body, on_core) == "1s0");
  CHECK(ModuleId(body, on_brick) == "2s2");
}

}  // namespace
}  // namespace plsc
