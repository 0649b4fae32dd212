#include "compiler/check_tests.h"

#include <catch2/catch.hpp>

#include "compiler/compiled.h"

namespace plsc {
namespace {

using testing::CodesOf;

// tests/programs has what is wrong on its line; here what is right, and the
// cases that depend on the rest of the file.
TEST_CASE("Tests need their environment only when something is sensed",
          "[check_tests]") {
  const std::string head = "plsc 1 alphabet plasticoding 1 ";
  CHECK(CodesOf(head + "test a -> { C }").empty());
  CHECK(CodesOf(head + "environment e { } test a in e -> { C }").empty());
  CHECK(CodesOf(head + "sense h: bool test a -> { C }") == "P2020");
  CHECK(CodesOf(head + "sense h: bool environment e { h = True } "
                       "test a in e -> { C }")
            .empty());
  CHECK(CodesOf(head + "test a in e -> { C }") == "P2020");
}

TEST_CASE("Iterations of tests are those that the genotype has",
          "[check_tests]") {
  const std::string head = "plsc 1 alphabet plasticoding 1 iterations 2 ";
  CHECK(CodesOf(head + "test a after 0 -> { C }").empty());
  CHECK(CodesOf(head + "test a after 2 -> { C }").empty());
  CHECK(CodesOf(head + "test a after 3 -> { C }") == "P2020");
  CHECK(CodesOf(head + "test a after -1 -> { C }") == "P2020");
  CHECK(CodesOf(head + "test a after 1e0 -> { C }") == "P2020");
}

TEST_CASE("Children of a module are told from those of its neighbours",
          "[check_tests]") {
  const std::string head = "plsc 1 alphabet plasticoding 1 ";
  CHECK(CodesOf(head + "test a -> body C { left B { left B { left T } } "
                       "right B { left T } front A1 { front A2 } }")
            .empty());
  CHECK(CodesOf(head + "test a -> body C { left B { left T } left T }") ==
        "P2021");
}

TEST_CASE("A broken item hides no environment that tests might mean",
          "[check_tests]") {
  CHECK(CodesOf("plsc 1 alphabet plasticoding 1\nsense h: bool\n"
                "environment e h = True }\n"
                "test a in e -> { C }") == "P1115");
}

TEST_CASE("Nesting has a limit", "[check_tests]") {
  const auto nested = [](int depth) {
    std::string text = "plsc 1 alphabet plasticoding 1 test a -> body C";
    for (int i = 0; i < depth; ++i) text += " { left B";
    for (int i = 0; i < depth; ++i) text += " }";
    return text;
  };
  CHECK(CodesOf(nested(100)).empty());
  CHECK(CodesOf(nested(101)) == "P3002");
  CHECK(CodesOf(nested(100000)) == "P3002");
}

}  // namespace
}  // namespace plsc
