#include "compiler/expectation.h"

#include <catch2/catch.hpp>

#include "compiler/compiled.h"
#include "compiler/print.h"

namespace plsc {
namespace {

using testing::Compiled;

TEST_CASE("Inline tests are compiled to what they expect", "[inline_test]") {
  const Program program = Compiled(
      "plsc 1 alphabet plasticoding 1 sense h: bool "
      "environment e { h = True } "
      "test s in e after 1 -> { C T T(0.5) } "
      "test b in e -> body C { right A1 { front T } left B { } }");
  REQUIRE(program.tests.size() == 2);
  const InlineTest& s = program.tests[0];
  CHECK(s.name == "s");
  CHECK(s.place == "e");
  CHECK(s.environment.values == std::vector<double>{1});
  CHECK(s.after == 1);
  REQUIRE(s.string.size() == 3);
  CHECK(s.string[0] == ExpectedSymbol{{plasticoding::kC, {}}, true});
  CHECK(s.string[1] == ExpectedSymbol{{plasticoding::kT, {}}, false});
  CHECK(s.string[2] == ExpectedSymbol{{plasticoding::kT, {0.5}}, true});
  const InlineTest& b = program.tests[1];
  CHECK(b.string.empty());
  CHECK(b.after == std::nullopt);
  REQUIRE(b.body.size() == 4);
  CHECK(b.body[1] == ExpectedModule{plasticoding::kA1, 1, Face::kRight});
  CHECK(b.body[2] == ExpectedModule{plasticoding::kT, 2, Face::kFront});
  CHECK(b.body[3] == ExpectedModule{plasticoding::kB, 1, Face::kLeft});
}

TEST_CASE("Tests are printed as they are written", "[inline_test]") {
  const Program program = Compiled(
      "plsc 1 alphabet plasticoding 1 "
      "test s after 1 -> { C T T(0.5) } "
      "test b -> body C { right A1 { front T } left B { } } test c -> body C");
  const std::string text = Print(program);
  CHECK(
      text.ends_with("test s after 1 -> { C T T(0.5) }\n\n"
                     "test b -> body C {\n"
                     "  right A1 {\n    front T\n  }\n  left B\n}\n\n"
                     "test c -> body C\n"));
  CHECK(PrintBody(program.tests[1].body, *program.genotype.alphabet) ==
        "C { right A1 { front T } left B }");
}

}  // namespace
}  // namespace plsc
