#include "runtime/scenario/scenario_physics.h"

#include <catch2/catch.hpp>
#include <set>
#include <sstream>

namespace plsc {

namespace {

PhysicsPatch Patch(const std::string& text) {
  const Source source("s", text);
  const YamlFile file(source);
  PhysicsPatch patch = ReadPhysics(*file.Root("physics"));
  REQUIRE(file.diagnostics().empty());
  return patch;
}

}  // namespace

TEST_CASE("A patch changes what it gives, be it the default",
          "[scenario_physics]") {
  PhysicsOptions base;
  base.step = 0.003;
  base.friction = 0.5;
  base.max_solver_failures = 0.7;
  const PhysicsOptions patched =
      Patched(base, Patch("step: 5 ms\nsolver: iterative\n"));
  CHECK(patched.engine == EngineKind::kOde);
  CHECK(patched.step == 0.005);
  CHECK(patched.solver == Solver::kIterative);
  CHECK(patched.friction == 0.5);
  CHECK(patched.max_solver_failures == 0.7);
}

TEST_CASE("The engine is a constant like every other", "[scenario_physics]") {
  PhysicsOptions swift;
  swift.engine = EngineKind::kArticulated;
  CHECK(PrintPhysicsChanges(swift, {}) == "{engine: articulated}");
  CHECK(Patched({}, Patch("engine: articulated")) == swift);
  CHECK(Patched(swift, Patch("engine: ode")) == PhysicsOptions{});
  CHECK(Patched(swift, Patch("step: 5 ms")) == swift);
}

TEST_CASE("Changes are printed shortly and read back", "[scenario_physics]") {
  PhysicsOptions moon;
  moon.gravity = 1.62;
  moon.friction = 0.3;
  const std::string text = PrintPhysicsChanges(moon, {});
  CHECK(text == "{gravity: 1.62 m/s2, friction: 0.3}");
  CHECK(Patched({}, Patch(text)) == moon);
}

TEST_CASE("Every constant is printed, once", "[scenario_physics]") {
  std::istringstream text(PrintPhysics({}, ""));
  std::set<std::string> keys;
  for (std::string line; std::getline(text, line);)
    CHECK(keys.insert(line.substr(0, line.find(':'))).second);
  CHECK(keys.size() == 20);  // 18 numbers, the engine and the solver
  CHECK(PrintServo({}, "").find("refresh: exact\n") != std::string::npos);
}

}  // namespace plsc
