#include "runtime/develop/developed.h"

#include <catch2/catch.hpp>

#include "tests/runtime/develop/compile_text.h"

namespace plsc {
namespace {

Key KeyOfRules(const std::string& rest) {
  const Genotype genotype = test::Robot(rest);
  const auto developed = DevelopActive(genotype, Regulate(genotype, {}));
  REQUIRE(developed);
  return DevelopedKey(genotype, *developed);
}

TEST_CASE("Robots have equal keys if they are equal to the last bit",
          "[developed]") {
  const Key key = KeyOfRules("iterations 1\nrule C -> { C add_left T(0.5) }");
  CHECK(key == KeyOfRules("iterations 1\nrule C -> { C B add_left T(0.5) }"));
  CHECK(key == KeyOfRules("max_modules 3 iterations 1\n"
                          "rule C -> { C add_right add_left T(0.5) }"));
  CHECK(key != KeyOfRules("iterations 1\nrule C -> { C add_right T(0.5) }"));
  CHECK(key != KeyOfRules("iterations 1\nrule C -> { C add_left "
                          "T(0.50000000000000011) }"));
  CHECK(KeyOfRules("iterations 1\nrule C -> { C add_left T(0) }") !=
        KeyOfRules("iterations 1\nrule C -> { C add_left T(-0) }"));
}

TEST_CASE("Without bodies it is the string", "[developed]") {
  const auto developed = [](const std::string& rest) {
    const Genotype genotype = test::Didactic(rest);
    return DevelopActive(genotype, Regulate(genotype, {}));
  };
  const auto one = developed("iterations 1\nrule X -> { Y a }");
  CHECK(one->string.size() == 2);
  CHECK_FALSE(one->robot);
  CHECK(one == developed("iterations 1\nrule X -> { Y a }\nrule Z -> { a }"));
  CHECK_FALSE(developed("iterations 60\nrule X -> { X X }"));
}

}  // namespace
}  // namespace plsc
