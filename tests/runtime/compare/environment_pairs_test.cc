#include "runtime/compare/environment_pairs.h"

#include <catch2/catch.hpp>

#include "compiler/compile.h"

namespace plsc {
namespace {

Program Compiled(const std::string& items) {
  const auto program =
      Compile(Source("text", "plsc 1\nalphabet plasticoding 1\n" + items));
  REQUIRE(program);
  return *program;
}

// "inclined=True (tilted)", ...
std::string Shown(const SharedEnvironments& shared) {
  std::string text;
  for (const SharedEnvironment& one : shared.environments) {
    text += (text.empty() ? "" : "; ") + one.text;
    for (const std::string& name : one.names) text += " " + name;
  }
  if (!shared.limitation.empty()) text += " !" + shared.limitation;
  return text;
}

TEST_CASE("Environments are told apart by the clauses of both versions",
          "[shared_environments]") {
  const std::string a =
      "sense a: bool\nsense b: bool\nenvironment yes { a = True, b = False }\n";
  const Program none = Compiled(a);
  const Program by_a = Compiled(a + "rule B -> if a = True then { T(0.5) }\n");
  const Program by_b = Compiled(
      "sense b: bool\nsense a: bool\n"
      "rule B -> if b = True then { T(0.5) }\n");
  CHECK(Shown(FindSharedEnvironments(none, none)) == "a=False,b=False yes");
  CHECK(Shown(FindSharedEnvironments(none, by_a)) ==
        "a=False,b=False; a=True,b=False yes");
  const SharedEnvironments both = FindSharedEnvironments(by_a, by_b);
  CHECK(Shown(both) ==
        "a=False,b=False; a=False,b=True; a=True,b=False yes; a=True,b=True");
  // Each version has them in its own order of states.
  CHECK(both.environments[1].before.values == std::vector<double>{0, 1});
  CHECK(both.environments[1].after.values == std::vector<double>{1, 0});
}

TEST_CASE("A state that one version does not know is no hindrance",
          "[shared_environments]") {
  const Program before = Compiled("environment here {}\n");
  const Program after = Compiled(
      "sense a: bool\nrule B -> if a = True then { T(0.5) }\n"
      "environment here { a = True }\n");
  const SharedEnvironments shared = FindSharedEnvironments(before, after);
  CHECK(Shown(shared) == "a=False; a=True here");
  CHECK(shared.environments[0].before.values.empty());
  CHECK(Shown(FindSharedEnvironments(before, before)) == "any here");
}

TEST_CASE("Of a state with other values only declared environments are shared",
          "[shared_environments]") {
  const Program before = Compiled(
      "sense a: { x, y }\nenvironment one { a = x }\nenvironment z { a = y "
      "}\n");
  const Program after =
      Compiled("sense a: { x, y, z }\nenvironment one { a = x }\n");
  CHECK(Shown(FindSharedEnvironments(before, after)) ==
        "a=x one !'sense a' changed its values");
}

TEST_CASE("Of ranges the common part is looked at", "[shared_environments]") {
  const Program before = Compiled(
      "sense t: real in 0..10\nrule B -> if t > 5 then { T(0.5) }\n"
      "environment cold { t = 1 }\n");
  const Program after = Compiled("sense t: real in 4..20\n");
  const SharedEnvironments shared = FindSharedEnvironments(before, after);
  CHECK(shared.environments.size() == 2);
  CHECK(shared.limitation.empty());
}

}  // namespace
}  // namespace plsc
