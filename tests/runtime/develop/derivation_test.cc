#include "runtime/develop/derivation.h"

#include <catch2/catch.hpp>

#include "tests/runtime/develop/compile_text.h"

namespace plsc {
namespace {

Derivation Derived(const Genotype& genotype) {
  const auto derivation =
      DeriveWithHistory(genotype, Regulate(genotype, Environment{}));
  REQUIRE(derivation);
  return *derivation;
}

TEST_CASE("a history has the strings of Derive", "[derivation]") {
  const Genotype genotype = test::Didactic(
      "iterations 5\nrule X -> { X Y }\nrule Y -> { Z a }\n"
      "rule Z -> { X Z }\n");
  const ActiveRules active = Regulate(genotype, Environment{});
  const Derivation derivation = Derived(genotype);
  const auto steps = DeriveSteps(genotype, active);
  REQUIRE(steps);
  REQUIRE(derivation.steps.size() == steps->size());
  for (std::size_t i = 0; i < steps->size(); ++i) {
    SymbolString string;
    for (const InsertionId id : derivation.steps[i])
      string.push_back(derivation[id].occurrence);
    CHECK(string == (*steps)[i]);
  }
  CHECK(FinalString(derivation) == Derive(genotype, active));
}

TEST_CASE("each symbol knows when it was inserted and for what",
          "[derivation]") {
  // X / X Y / X Y Z a: the Z of the second rewriting is for the Y of the
  // first.
  const Derivation derivation = Derived(
      test::Didactic("iterations 2\nrule X -> { X Y }\nrule Y -> { Z a }\n"));
  REQUIRE(derivation.string().size() == 4);
  const InsertionId z = derivation.string()[2];
  CHECK(derivation[z].iteration == 2);
  CHECK(derivation[z].occurrence.position == 0);
  const InsertionId y = derivation[z].parent;
  CHECK(derivation[y].iteration == 1);
  CHECK(derivation[y].occurrence.position == 1);
  CHECK(derivation[y].child_count == 2);
  CHECK(derivation[y].first_child == z);
  CHECK(Ancestry(derivation, z) == std::vector<InsertionId>{z, y, 0});
  CHECK(derivation[0].parent == kNoInsertion);
  CHECK(derivation[0].iteration == 0);
}

TEST_CASE("a symbol without active rules stays the same insertion",
          "[derivation]") {
  const Derivation derivation =
      Derived(test::Didactic("iterations 3\nrule X -> { Y a }\n"));
  CHECK(derivation.steps[1] == derivation.steps[3]);
  CHECK(derivation.insertions.size() == 3);
  CHECK(derivation[derivation.string()[0]].iteration == 1);
  CHECK(derivation[derivation.string()[0]].child_count == 0);
}

TEST_CASE("a string or history beyond its limit is none", "[derivation]") {
  const Genotype doubling =
      test::Didactic("iterations 21\nrule X -> { X X }\n");
  CHECK_FALSE(DeriveWithHistory(doubling, Regulate(doubling, Environment{})));
  // A string of 2^20 symbols is allowed, but not to keep nine of them.
  std::string y;
  std::string z;
  for (int i = 0; i < 1024; ++i) {
    y += "Y ";
    z += "Z ";
  }
  const auto waiting = [&](int iterations) {
    return test::Didactic("iterations " + std::to_string(iterations) +
                          "\nrule X -> { " + y + "}\nrule Y -> { " + z +
                          "}\nrule Z -> { Z }\n");
  };
  const Genotype short_one = waiting(3);
  CHECK(DeriveWithHistory(short_one, Regulate(short_one, Environment{})));
  const Genotype long_one = waiting(10);
  const ActiveRules active = Regulate(long_one, Environment{});
  CHECK(Derive(long_one, active));
  CHECK_FALSE(DeriveWithHistory(long_one, active));
}

}  // namespace
}  // namespace plsc
