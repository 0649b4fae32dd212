#include "runtime/develop/growth.h"

#include <catch2/catch.hpp>
#include <limits>

#include "runtime/develop/derive.h"
#include "tests/runtime/develop/compile_text.h"

namespace plsc {
namespace {

std::uint64_t LengthOf(const std::string& rest) {
  const Genotype genotype = test::Didactic(rest);
  return DerivedLength(genotype, Regulate(genotype, {}));
}

TEST_CASE("The length of a string is known without deriving it", "[growth]") {
  // Every pair of productions for X and Y out of these, 0 to 5 rewritings.
  const std::vector<std::string> productions = {
      "", "{ X }", "{ a }", "{ X Y }", "{ Y X }", "{ X X }", "{ Y a Y }"};
  for (const std::string& x : productions)
    for (const std::string& y : productions)
      for (int iterations = 0; iterations <= 5; ++iterations) {
        std::string rules = "iterations " + std::to_string(iterations) + "\n";
        if (!x.empty()) rules += "rule X -> " + x + "\n";
        if (!y.empty()) rules += "rule Y -> " + y + "\n";
        const Genotype genotype = test::Didactic(rules);
        const ActiveRules active = Regulate(genotype, {});
        INFO(rules);
        REQUIRE(DerivedLength(genotype, active) ==
                Derive(genotype, active)->size());
      }
}

TEST_CASE("Lengths beyond 64 bits stay at the greatest number", "[growth]") {
  CHECK(LengthOf("iterations 21\nrule X -> { X X }\n") == 1u << 21);
  CHECK(LengthOf("iterations 63\nrule X -> { X X }\n") == std::uint64_t{1}
                                                              << 63);
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
  CHECK(LengthOf("iterations 64\nrule X -> { X X }\n") == kMost);
  CHECK(LengthOf("iterations 100\nrule X -> { X Y X }\nrule Y -> { Y Y }\n") ==
        kMost);
}

TEST_CASE("The leading C of later productions is not counted", "[growth]") {
  const Genotype genotype =
      test::Robot("iterations 1\nrule C -> { C B }\nrule C -> { C T(1) }\n");
  CHECK(DerivedLength(genotype, Regulate(genotype, {})) == 3);
}

TEST_CASE("The symbol that multiplies most is named", "[growth]") {
  const Genotype genotype = test::Didactic(
      "rule X -> { X X a }\nrule Y -> { Y Y Y }\nrule Z -> { Z }\n");
  const auto greatest = GreatestMultiplier(Regulate(genotype, {}));
  REQUIRE(greatest);
  CHECK((*genotype.alphabet)[greatest->symbol].name == "Y");
  CHECK(greatest->copies == 3);
  CHECK(greatest->length == 3);
  const Genotype none = test::Didactic("rule X -> { X Y }\n");
  CHECK_FALSE(GreatestMultiplier(Regulate(none, {})));
}

TEST_CASE("A string is C and its readings, the newest first", "[growth]") {
  const Genotype genotype = test::Robot(
      "iterations 4\nrule C -> { C add_left A1(0.5, 2, 3, 1) move_left B }\n"
      "rule A1 -> { A1(0.5, 2, 3, 1) loop(0.5) }\nrule B -> { T(1) B B }\n");
  const ActiveRules active = Regulate(genotype, {});
  const SymbolString string = *Derive(genotype, active);
  // B becomes 1, 3, 7 and 15 symbols, A1 1 to 4; two commands stay.
  CHECK(ReadingLengths(genotype, active) ==
        std::vector<std::uint64_t>{4, 7, 12, 21});
  CHECK(string.size() == 1 + 4 + 7 + 12 + 21);
  for (const std::size_t begin : {1u, 5u, 12u, 24u})
    CHECK(string[begin].symbol == plasticoding::kAddLeft);
  CHECK(ReadingLengths(test::Robot("iterations 0\nrule C -> { C B }"),
                       Regulate(test::Robot("rule C -> { C B }"), {}))
            .empty());
  CHECK(ReadingLengths(test::Robot(""), Regulate(test::Robot(""), {})).empty());
}

}  // namespace
}  // namespace plsc
