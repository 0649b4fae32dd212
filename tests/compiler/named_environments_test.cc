#include "compiler/named_environments.h"

#include <catch2/catch.hpp>

#include "tests/compiler/compiled.h"

namespace plsc {
namespace {

Program WithTwo(const std::string& environments) {
  return testing::Compiled(
      "plsc 1\nalphabet plasticoding 1\nsense wet: bool\n"
      "sense heat: real in 0.0..30.0\n" +
      environments + "rule C -> { C }\n");
}

TEST_CASE("an environment is found by its name, or written out",
          "[named_environments]") {
  const Program program =
      WithTwo("environment rain { wet = True, heat = 12.5 }\n");
  const auto named = FindEnvironment(program, Source("--env", "rain"));
  REQUIRE(named);
  CHECK(*named == program.environments[0]);

  const auto written =
      FindEnvironment(program, Source("--env", "heat=3, wet=False"));
  REQUIRE(written);
  CHECK(written->environment.values == std::vector<double>{0, 3});
  CHECK(written->name == "wet=False,heat=3");

  CHECK_FALSE(FindEnvironment(program, Source("--env", "snow")));
  CHECK_FALSE(FindEnvironment(program, Source("--env", "wet=True")));
}

TEST_CASE("a value beyond what a robot senses is said with the environment",
          "[named_environments]") {
  const auto found = FindEnvironment(
      WithTwo(""), Source("--env", "heat=3,wet=False,dark=True"));
  REQUIRE(found);
  CHECK(found.diagnostics().size() == 1);
}

TEST_CASE("without a word the environments of a file are meant",
          "[named_environments]") {
  const Program both = WithTwo(
      "environment rain { wet = True, heat = 12.5 }\n"
      "environment sun { wet = False, heat = 30.0 }\n");
  CHECK(UsualEnvironments(both) == both.environments);
  CHECK_FALSE(UsualEnvironments(WithTwo("")));
  const Program blind =
      testing::Compiled("plsc 1\nalphabet plasticoding 1\nrule C -> { C }\n");
  CHECK(UsualEnvironments(blind) == std::vector<NamedEnvironment>{{"any", {}}});
}

TEST_CASE("an example is an environment", "[named_environments]") {
  const Program program = WithTwo("");
  const std::string example = ExampleOfEnvironment(program.genotype.states);
  CHECK(example == "wet=False,heat=0");
  CHECK(FindEnvironment(program, Source("--env", example)));
}

}  // namespace
}  // namespace plsc
