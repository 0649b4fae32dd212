#include "compiler/layout.h"

#include <catch2/catch.hpp>

#include "compiler/format.h"

namespace plsc {
namespace {

struct LayoutRow {
  const char* why;
  const char* text;  // behind the first two lines
  const char* laid_out;
};

void CheckAll(const std::vector<LayoutRow>& rows, bool is_compact) {
  for (const LayoutRow& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const Source source(
          "a.pls", std::string("plsc 1\nalphabet plasticoding 1\n") + row.text);
      FormatOptions options;
      options.compact = is_compact;
      const Result<std::string> result = Format(source, options);
      INFO(Render(result.diagnostics(), source));
      REQUIRE(result);
      CHECK(*result ==
            std::string("plsc 1\n\nalphabet plasticoding 1\n") + row.laid_out);
    }
  }
}

TEST_CASE("Items and comments have their places", "[layout]") {
  CheckAll(
      {
          {"header items in order, spelling kept",
           "max_modules 007\nlet w = 0.50\naxiom C\nsense a:bool",
           "sense a: bool\nlet w = 0.50\naxiom C\nmax_modules 007\n"},
          {"an empty line between header items stays",
           "axiom C\n\n\n\niterations 3\nmax_modules 2",
           "axiom C\n\niterations 3\nmax_modules 2\n"},
          {"comments move with their item",
           "# about modules\nmax_modules 2 # few\n# about the axiom\naxiom C",
           "# about the axiom\naxiom C\n# about modules\nmax_modules 2  # "
           "few\n"},
          {"rules are grouped, in file order within",
           "rule B -> { T(1) }\nrule C -> { C }\nrule B -> { B }",
           "\nrule C -> {\n  C\n}\n\nrule B -> {\n  T(1)\n}\n\n"
           "rule B -> {\n  B\n}\n"},
          {"comments within a production stay at their symbol",
           "rule B -> { # all\n# first\nT( 1e0 ) # one\n\n# last\n}",
           "\nrule B -> {  # all\n  # first\n  T(1e0)  # one\n\n  # last\n}\n"},
          {"a comment between arguments comes before the symbol",
           "rule B -> { T( # why\n 1) B }",
           "\nrule B -> {\n  # why\n  T(1)\n  B\n}\n"},
          {"a comment in a clause comes before the rule",
           "sense a: bool rule B -> if a # why\n = True then { B }",
           "sense a: bool\n\n# why\nrule B -> if a = True then {\n  B\n}\n"},
          {"empty lines around comments stay, one each",
           "rule B -> { B }\n\n# apart\n\n\n# close\nrule T -> { B }\n\n# end",
           "\nrule B -> {\n  B\n}\n\n# apart\n\n# close\nrule T -> {\n  B\n}\n"
           "\n# end\n"},
          {"an environment fits one line",
           "sense a:bool sense b:bool environment e { b = True\na = False, }",
           "sense a: bool\nsense b: bool\n\n"
           "environment e { b = True, a = False }\n"},
          {"an environment with comments has a line a state",
           "sense a:bool sense b:bool environment e { b = True # sun\n"
           "a = False }",
           "sense a: bool\nsense b: bool\n\n"
           "environment e {\n  b = True,  # sun\n  a = False\n}\n"},
          {"blanks at the end of a comment go", "axiom C # core  \t\r\n",
           "axiom C  # core\n"},
      },
      false);
}

TEST_CASE("Compact rules have a group a line", "[layout]") {
  CheckAll(
      {
          {"a short rule fits one line", "rule B -> {\n  B\n  T(1)\n}",
           "\nrule B -> { B T(1) }\n"},
          {"a moving command ends a line",
           "rule C -> { C move_ref_I(1, 1) add_edge(0.123456789) add_left B "
           "move_left loop(0.5) add_front T(0.5) move_back B }",
           "\nrule C -> {\n  C\n"
           "  move_ref_I(1, 1) add_edge(0.123456789) add_left B move_left\n"
           "  loop(0.5) add_front T(0.5) move_back\n  B\n}\n"},
          {"rules of a symbol stand together",
           "rule B -> { B }\nrule B -> { T(1) }\nrule T -> { B }",
           "\nrule B -> { B }\nrule B -> { T(1) }\n\nrule T -> { B }\n"},
          {"a comment ends a line", "rule B -> { B # one\n T(1) B }",
           "\nrule B -> {\n  B  # one\n  T(1) B\n}\n"},
      },
      true);
}

TEST_CASE("An own alphabet has a line a group, or a symbol with comments",
          "[layout]") {
  const auto format = [](const char* text) {
    const Result<std::string> result =
        Format(Source("a.pls", std::string("plsc 1\n\n") + text));
    REQUIRE(result);
    return result->substr(result->find("alphabet"));
  };
  CHECK(format("alphabet m { replaceable X; replaceable Y terminal "
               "a ( n :int in 0 .. 5 ) } axiom X") ==
        "alphabet m {\n  replaceable X, Y;\n  terminal a(n: int in 0..5)\n}\n"
        "axiom X\n");
  CHECK(format("alphabet m { replaceable X, # first\n Y; terminal a }\n"
               "axiom X") ==
        "alphabet m {\n  replaceable X;  # first\n  replaceable Y;\n"
        "  terminal a\n}\naxiom X\n");
}

}  // namespace
}  // namespace plsc
