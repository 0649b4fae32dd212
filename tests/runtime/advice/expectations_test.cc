#include "runtime/advice/expectations.h"

#include <catch2/catch.hpp>

#include "compiler/print.h"

namespace plsc {
namespace {

// The label of the first failing test of `text`, or "passes".
std::string Outcome(const std::string& text) {
  const Source source("a", text);
  const auto mapped = CompileWithMap(source);
  if (!mapped) return Render(mapped.diagnostics(), source);
  for (std::size_t i = 0; i < mapped->program.tests.size(); ++i)
    if (const auto failure = RunInlineTest(*mapped, i)) {
      const auto [line, column] = source.PositionOf(failure->span.begin);
      CHECK(failure->code == (failure->notes.empty() ? Code::kTooLongString
                                                     : Code::kFailedTest));
      return std::to_string(line) + ":" + std::to_string(column) + " " +
             failure->label;
    }
  return "passes";
}

// The string `C T(0.5) add_left A1(...) B`: a sensor, an arm of two modules.
constexpr const char* kRobot =
    "plsc 1 alphabet plasticoding 1 sense hot: bool iterations 1\n"
    "environment warm { hot = True } environment cold { hot = False }\n"
    "rule C -> if hot = True then { C add_front T(0.5) add_left A1(1, 2, 3, 4) "
    "move_left add_front B }\n";

TEST_CASE("Inline tests pass when the string is as expected", "[inline_test]") {
  const std::string robot = kRobot;
  const std::string all =
      "C add_front T(0.5) add_left A1(1, 2, 3, 4) "
      "move_left add_front B";
  CHECK(Outcome(robot + "test a in warm -> { " + all + " }") == "passes");
  CHECK(Outcome(robot + "test a in cold -> { C }") == "passes");
  CHECK(Outcome(robot + "test a in warm after 0 -> { C }") == "passes");
  CHECK(Outcome(robot +
                "test a in warm -> { C add_front T add_left A1 move_left "
                "add_front B }") == "passes");
}

TEST_CASE("Inline tests of a string point at what is otherwise",
          "[inline_test]") {
  const std::string robot = kRobot;
  CHECK(Outcome(robot + "test a in warm -> { C add_left }") ==
        "4:23 symbol 2 of the string is add_front");
  CHECK(Outcome(robot + "test a in warm -> { C add_front T(0.25) }") ==
        "4:33 symbol 3 of the string is T(0.5)");
  CHECK(Outcome(robot + "test a in warm -> { C add_front }") ==
        "4:33 the string goes on with T(0.5)");
  CHECK(Outcome(robot + "test a in cold -> { C B }") ==
        "4:23 the string ends before this, after 1 symbol");
}

TEST_CASE("Inline tests of a body compare the tree", "[inline_test]") {
  const std::string robot = kRobot;
  // In whatever order the faces are written.
  CHECK(Outcome(robot + "test a in warm -> body C { left A1 { front B } "
                        "front T }") == "passes");
  CHECK(Outcome(robot + "test a in warm -> body C { front T "
                        "left A1 { front B } }") == "passes");
  CHECK(Outcome(robot + "test a in cold -> body C") == "passes");
  // The fourth module comes to the core's back.
  CHECK(Outcome(
            "plsc 1 alphabet plasticoding 1 iterations 1\n"
            "rule C -> { C add_left B add_front B add_right B add_left T(1) }\n"
            "test a -> body C { left B front B right B back T }") == "passes");
}

TEST_CASE("Inline tests of a body point at what is otherwise",
          "[inline_test]") {
  const std::string robot = kRobot;
  CHECK(Outcome(robot + "test a in warm -> body C { front T "
                        "left A2 { front B } }") == "4:36 this module is A1");
  CHECK(Outcome(robot + "test a in warm -> body C { left A1 { front B } }") ==
        "4:24 has T at its front, which is not expected");
  CHECK(Outcome(robot + "test a in warm -> body C { front T left A1 }") ==
        "4:36 has B at its front, which is not expected");
  CHECK(Outcome(robot + "test a in warm -> body C { front T "
                        "left A1 { front B } right B }") ==
        "4:56 there is no such module");
  CHECK(Outcome(robot + "test a in cold -> body C { right B }") ==
        "4:28 there is no such module");
}

TEST_CASE("A test whose string grows too long fails", "[inline_test]") {
  CHECK(Outcome("plsc 1 alphabet plasticoding 1 iterations 30\n"
                "rule B -> { B B } rule C -> { C B }\n"
                "test a -> { C }") ==
        "3:6 development would produce more than 1048576 symbols");
  CHECK(Outcome("plsc 1 alphabet plasticoding 1 iterations 30\n"
                "rule B -> { B B } rule C -> { C B }\n"
                "test a after 1 -> { C B }") == "passes");
}

TEST_CASE("Any alphabet's strings can be tested", "[inline_test]") {
  const std::string didactic =
      "plsc 1 alphabet didactic { replaceable X, Y, Z; terminal a } axiom X\n"
      "rule X -> { X Y } rule Y -> { Z a } rule Z -> { X Z }\n";
  CHECK(Outcome(didactic + "test t after 2 -> { X Y Z a }") == "passes");
  CHECK(Outcome(didactic + "test t -> { X Y Z a }") ==
        "3:21 the string goes on with X");
}

}  // namespace
}  // namespace plsc
