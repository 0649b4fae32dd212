#include "compiler/check.h"

#include <catch2/catch.hpp>
#include <string>

#include "compiler/compiled.h"

namespace plsc {
namespace {

using testing::CodesOf;

TEST_CASE("Limits hold when they are declared", "[check]") {
  const std::string head =
      "plsc 1 alphabet plasticoding 1 sense a: bool sense b: bool\n";
  const std::string three =
      "rule B -> if a = True and b = True or b = False then { B }\n";
  const std::string twice = "rule B -> { B }\nrule B -> { T(1) }\n";
  CHECK(CodesOf(head + three + twice).empty());
  CHECK(CodesOf(head + "max_terms 3\n" + three).empty());
  CHECK(CodesOf(head + "max_terms 2\n" + three) == "P3001");
  CHECK(CodesOf(head + "max_rules 2\n" + twice).empty());
  // Once a symbol, however many there are too many.
  CHECK(CodesOf(head + "max_rules 1\n" + twice + twice) == "P3001");
}

TEST_CASE("An environment has one value for every state", "[check]") {
  const std::string head =
      "plsc 1 alphabet plasticoding 1 sense a: bool "
      "sense r: real in 0..1 environment e { ";
  struct Row {
    const char* entries;
    const char* codes;
  };
  const std::vector<Row> rows = {
      {"a = True, r = 0", ""},
      {"r = 1 a = False", ""},
      {"", "P2015"},
      {"a = True", "P2015"},
      {"a = True, r = 1.5", "P2015"},
      {"a = True, a = True, r = 1", "P2015"},
      {"a = True, r = 1, x = 1", "P2005"},
      {"a = 5", "P2006"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.entries) {
      CHECK(CodesOf(head + row.entries + " }") == row.codes);
    }
  }
  CHECK(CodesOf("plsc 1 alphabet plasticoding 1 environment e {}").empty());
}

TEST_CASE("Clauses that are constant are warned of", "[check]") {
  const std::string head =
      "plsc 1 alphabet plasticoding 1 sense a: bool sense b: bool "
      "sense r: real in 0..10 sense e: { x, y, z } rule B -> if ";
  struct Row {
    const char* clause;
    bool is_constant;
  };
  const std::vector<Row> rows = {
      {"a = True", false},
      {"a = True and b = True", false},
      {"a = True or a = False", true},
      {"a = True and a = False", true},
      {"a = True or b = True and a = False", false},
      {"a = True or b = True or b = False", true},
      {"e != x or e != y", true},
      {"e = x or e = y or e = z", true},
      {"e = x or e = y", false},
      {"r >= 0", true},
      {"r > 0", false},
      {"r > 10", true},
      {"r < 5 or r > 5", false},
      {"r < 5 or r >= 5", true},
      {"r > 5 and r < 5.000000000000001", true},
      {"r > 4 and r < 6", false},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.clause) {
      CHECK(CodesOf(head + row.clause + " then { B }") ==
            (row.is_constant ? "W3002" : ""));
    }
  }
}

TEST_CASE("A table too large to look at is not made", "[check]") {
  std::string text = "plsc 1 alphabet plasticoding 1\n";
  std::string clause;
  for (int i = 0; i < 17; ++i) {
    const std::string state = "s" + std::to_string(i);
    text += "sense " + state + ": bool\n";
    clause +=
        (i == 0 ? "" : " or ") + state + " = True or " + state + " = False";
  }
  CHECK(CodesOf(text + "rule B -> if " + clause + " then { B }").empty());
}

}  // namespace
}  // namespace plsc
