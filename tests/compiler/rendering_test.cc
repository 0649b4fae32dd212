// The full text of diagnostics, as users read it. A change here is a change
// of what people see: look at it before accepting it.

#include <catch2/catch.hpp>
#include <string>

#include "compiler/compile.h"

namespace plsc {
namespace {

struct RenderingRow {
  const char* why;
  const char* source;
  const char* text;
};

// Lines 1 to 3 of most sources.
#define HEAD "plsc 1\nalphabet plasticoding 1\nsense inclined: bool\n"

const std::vector<RenderingRow>& Rows() {
  static const std::vector<RenderingRow> kRows = {
      {"the version is missing", "genotype gecko\n",
       R"(error[P5001]: a genotype file starts with the language version
 --> a.pls:1:1
1 | genotype gecko
  | ^^^^^^^^ expected 'plsc 1' before this
  = help: add 'plsc 1' as the first line
)"},
      {"the language is newer", "plsc 3\n",
       R"(error[P5002]: this file needs plsc language 3; this tool reads 1
 --> a.pls:1:6
1 | plsc 3
  |      ^
  = help: use a newer plsc, or a file of language 1
)"},
      {"a typing error in a keyword", HEAD "rulle B -> {\n  B\n}\n",
       R"(error[P1101]: unknown item 'rulle'
 --> a.pls:4:1
4 | rulle B -> {
  | ^^^^^ did you mean 'rule'?
)"},
      {"no comparison", HEAD "rule C -> if inclined True then { C }\n",
       R"(error[P1103]: expected a comparison after state 'inclined'
 --> a.pls:4:23
4 | rule C -> if inclined True then { C }
  |                       ^^^^ expected '=', '!=', '<', '<=', '>' or '>='
  = help: write 'inclined = True'
)"},
      {"another language's operators",
       HEAD "rule C -> if inclined == true && inclined = False then { C }\n",
       R"(error[P1104]: '==' is not a plsc operator
 --> a.pls:4:23
4 | rule C -> if inclined == true && inclined = False then { C }
  |                       ^^ use '='
  = note: also 'true' -> 'True' (column 26), '&&' -> 'and' (column 31)
)"},
      {"nothing after and",
       HEAD "rule C -> if inclined = True and then { C }\n",
       R"(error[P1105]: expected a term after 'and', found 'then'
 --> a.pls:4:34
4 | rule C -> if inclined = True and then { C }
  |                                  ^^^^ expected 'STATE = VALUE' here
)"},
      {"no then", HEAD "rule C -> if inclined = True { C }\n",
       R"(error[P1106]: expected 'and', 'or' or 'then', found '{'
 --> a.pls:4:30
4 | rule C -> if inclined = True { C }
  |                              ^ insert 'then' before this
)"},
      {"a production without an end",
       HEAD "rule C -> if inclined = True then {\n  C\n\n"
            "rule B -> { add_left T(0.1) }\n",
       R"(error[P1107]: this production is never closed
 --> a.pls:4:35
4 | rule C -> if inclined = True then {
  |                                   ^ opened here
7 | rule B -> { add_left T(0.1) }
  | ---- the next item starts here; insert '}' before
)"},
      {"a number that ends in a point", HEAD "rule B -> { T(2.) }\n",
       R"(error[P1110]: expected digits after '.'
 --> a.pls:4:15
4 | rule B -> { T(2.) }
  |               ^^ write '2.0' or '2'
)"},
      {"not a number", HEAD "rule B -> { T(nan) }\n",
       R"(error[P1111]: 'nan' is not a number in plsc
 --> a.pls:4:15
4 | rule B -> { T(nan) }
  |               ^^^ numbers are finite and decimal
)"},
      {"no double is so large", HEAD "rule B -> { T(1e400) }\n",
       R"(error[P1112]: 1e400 does not fit a 64-bit floating-point number
 --> a.pls:4:15
4 | rule B -> { T(1e400) }
  |               ^^^^^ largest magnitude is 1.7976931348623157e308
)"},
      {"a symbol of the authors' program",
       HEAD "rule B -> {\n  AJ1(-0.57, 1.8, 4.3, 1.2)\n}\n",
       R"(error[P2001]: unknown symbol 'AJ1' in alphabet 'plasticoding'
 --> a.pls:5:3
5 |   AJ1(-0.57, 1.8, 4.3, 1.2)
  |   ^^^ write 'A2'
  = note: AJ1 is Revolve's horizontal joint; the paper's name for it is A2 (not A1), and its parameters are ordered w, a, p, o
)"},
      {"too few arguments", HEAD "rule B -> {\n\tA1(0.1, 2.0, 3.0)\n}\n",
       R"(error[P2002]: A1 takes 4 parameters (w, a, p, o), 3 given
 --> a.pls:5:2
5 |     A1(0.1, 2.0, 3.0)
  |     ^^^^^^^^^^^^^^^^^ missing 'o' (phase offset, in periods)
)"},
      {"edges are counted", HEAD "rule B -> { move_ref_I(1.5, 2) }\n",
       R"(error[P2003]: parameter 't' of move_ref_I must be a whole number
 --> a.pls:4:24
4 | rule B -> { move_ref_I(1.5, 2) }
  |                        ^^^ written without '.' and exponent, as in '2'
)"},
      {"out of range", HEAD "rule B -> { A1(0.1, 12.0, 3.0, 1.0) }\n",
       R"(error[P2004]: parameter 'a' of A1 is 12.0, expected 1..10
 --> a.pls:4:21
4 | rule B -> { A1(0.1, 12.0, 3.0, 1.0) }
  |                     ^^^^ A1(w in -1..1, a in 1..10, p in 1..10, o in 1..10)
  = help: '--allow-range' makes this a warning
)"},
      {"an unknown state", HEAD "rule C -> if inclind = True then { C }\n",
       R"(error[P2005]: state 'inclind' is not declared
 --> a.pls:4:14
4 | rule C -> if inclind = True then { C }
  |              ^^^^^^^ did you mean 'inclined'?
3 | sense inclined: bool
  |       -------- declared here
)"},
      {"a value of another type",
       HEAD "sense temperature: real in -40..60\n"
            "rule C -> if temperature = True then { C }\n",
       R"(error[P2006]: 'temperature' is a real state and cannot be compared with True
 --> a.pls:5:28
5 | rule C -> if temperature = True then { C }
  |                            ^^^^ compare with a number, as in 'temperature > 10'
4 | sense temperature: real in -40..60
  |       ----------- declared here
)"},
      {"a rule for a command", HEAD "rule add_left -> { B }\n",
       R"(error[P2007]: 'add_left' is a command and cannot have a rule
 --> a.pls:4:6
4 | rule add_left -> { B }
  |      ^^^^^^^^ replaceable symbols are C, B, A1, A2, T
)"},
      {"a second core", HEAD "rule B -> { add_left C }\n",
       R"(error[P2008]: the core C may appear only as the first symbol of a rule for C
 --> a.pls:4:22
4 | rule B -> { add_left C }
  |                      ^ a robot has exactly one core
)"},
      {"too many terms",
       HEAD "max_terms 1\n"
            "rule C -> if inclined = True or inclined = False then { C }\n",
       R"(error[P3001]: clause has 2 terms; this genotype allows at most 1
 --> a.pls:5:14
5 | rule C -> if inclined = True or inclined = False then { C }
  |              ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
4 | max_terms 1
  | ----------- declared here
)"},
      {"a clause that says nothing",
       HEAD "rule C -> if inclined = True or inclined = False then { C }\n",
       R"(warning[W3002]: this clause is true in every environment
 --> a.pls:4:14
4 | rule C -> if inclined = True or inclined = False then { C }
  |              ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ whatever inclined is
  = help: without the clause the rule is always active
)"},
      {"a merge conflict", HEAD "<<<<<<< HEAD\n",
       R"(error[P5010]: unresolved merge conflict marker
 --> a.pls:4:1
4 | <<<<<<< HEAD
  | ^^^^^^^ resolve the conflict and remove the markers
)"},
  };
  return kRows;
}

#undef HEAD

TEST_CASE("Diagnostics read as documented", "[rendering]") {
  for (const RenderingRow& row : Rows()) {
    DYNAMIC_SECTION(row.why) {
      const Source source("a.pls", row.source);
      CHECK(Render(Compile(source).diagnostics(), source) == row.text);
    }
  }
}

}  // namespace
}  // namespace plsc
