#include "runtime/develop/regulate.h"

#include <catch2/catch.hpp>

#include "compiler/truth.h"
#include "tests/runtime/develop/compile_text.h"

namespace plsc {
namespace {

constexpr const char* kStates =
    "sense a: bool\nsense b: bool\nsense c: bool\n"
    "sense heat: real in -40..60\n";

TEST_CASE("active rules are listed by symbol", "[regulate]") {
  const Genotype genotype = test::Didactic(
      "sense p: bool rule Z -> { a } rule X -> if p = True then { a } "
      "rule X -> { Y } rule Y -> if p = True then { a }");
  const auto list = [&](double p) {
    std::string text;
    for (const SymbolRules& symbol :
         BySymbol(genotype, Regulate(genotype, {{p}}))) {
      text += (*genotype.alphabet)[symbol.symbol].name + ":";
      for (const RuleIndex rule : symbol.active) text += std::to_string(rule);
      text += " ";
    }
    return text;
  };
  CHECK(list(0) == "X:1 Y: Z:3 ");
  CHECK(list(1) == "X:01 Y:2 Z:3 ");
}

TEST_CASE("and binds tighter than or, whatever the order", "[regulate]") {
  struct Row {
    const char* clause;
    bool (*holds)(bool, bool, bool);
  };
  const std::vector<Row> rows = {
      {"a = True", [](bool a, bool, bool) { return a; }},
      {"a = False", [](bool a, bool, bool) { return !a; }},
      {"a != True", [](bool a, bool, bool) { return !a; }},
      {"a = True and b = True", [](bool a, bool b, bool) { return a && b; }},
      {"a = True or b = True", [](bool a, bool b, bool) { return a || b; }},
      {"a = True or b = True and c = True",
       [](bool a, bool b, bool c) { return a || (b && c); }},
      {"a = True and b = True or c = True",
       [](bool a, bool b, bool c) { return (a && b) || c; }},
      {"a = True and b = False or b = True and c = False",
       [](bool a, bool b, bool c) { return (a && !b) || (b && !c); }},
      {"a = True or b = True and a = False or c = True",
       [](bool a, bool b, bool c) { return a || (b && !a) || c; }},
  };
  for (const Row& row : rows) {
    const Genotype genotype = test::Robot(
        std::string(kStates) + "rule B -> if " + row.clause + " then { B }\n");
    for (int bits = 0; bits < 8; ++bits) {
      const bool a = (bits & 1) != 0;
      const bool b = (bits & 2) != 0;
      const bool c = (bits & 4) != 0;
      INFO(row.clause << " with " << a << b << c);
      const Environment environment{{double(a), double(b), double(c), 0}};
      CHECK(ClauseHolds(genotype.rules[0].clause, environment.values) ==
            row.holds(a, b, c));
    }
  }
}

TEST_CASE("thresholds compare as they are written", "[regulate]") {
  struct Row {
    const char* clause;
    bool below;
    bool at;
    bool above;
  };
  const std::vector<Row> rows = {
      {"heat > 30.5", false, false, true},
      {"heat >= 30.5", false, true, true},
      {"heat < 30.5", true, false, false},
      {"heat <= 30.5", true, true, false},
  };
  for (const Row& row : rows) {
    INFO(row.clause);
    const Genotype genotype = test::Robot(
        std::string(kStates) + "rule B -> if " + row.clause + " then { B }\n");
    const auto holds = [&](double heat) {
      return ClauseHolds(genotype.rules[0].clause,
                         std::vector<double>{0, 0, 0, heat});
    };
    CHECK(holds(30.25) == row.below);
    CHECK(holds(30.5) == row.at);
    CHECK(holds(30.75) == row.above);
  }
}

std::string JoinedText(const Genotype& genotype, SymbolId head,
                       const Environment& environment) {
  std::string text;
  const ActiveRules active = Regulate(genotype, environment);
  for (const Occurrence& o : active.joined[head]) {
    if (!text.empty()) text += ' ';
    text += (*genotype.alphabet)[o.symbol].name;
  }
  return text;
}

TEST_CASE("productions of all active rules are joined in file order",
          "[regulate]") {
  const Genotype genotype = test::Robot(
      "sense hot: bool\n"
      "rule B -> if hot = True then { B add_left }\n"
      "rule B -> { add_right }\n"
      "rule B -> if hot = True or hot = False then { T(0.5) }\n");
  CHECK(JoinedText(genotype, plasticoding::kB, {{1}}) ==
        "B add_left add_right T");
  CHECK(JoinedText(genotype, plasticoding::kB, {{0}}) == "add_right T");
  CHECK(JoinedText(genotype, plasticoding::kT, {{0}}).empty());
}

TEST_CASE("only the first of the active rules of C brings its C",
          "[regulate]") {
  const Genotype genotype = test::Robot(
      "sense hot: bool\n"
      "rule C -> if hot = True then { C add_left }\n"
      "rule C -> { C add_right }\n"
      "rule C -> { C }\n");
  CHECK(JoinedText(genotype, plasticoding::kC, {{1}}) ==
        "C add_left add_right");
  CHECK(JoinedText(genotype, plasticoding::kC, {{0}}) == "C add_right");
}

TEST_CASE("an own alphabet joins whole productions", "[regulate]") {
  const Genotype genotype =
      test::Didactic("rule X -> { X a }\nrule X -> { X Y }\n");
  CHECK(JoinedText(genotype, SymbolId{0}, {}) == "X a X Y");
}

TEST_CASE("regulation leaves the genotype as it was", "[regulate]") {
  const Genotype genotype =
      test::Robot("rule C -> { C B }\nrule C -> { C add_left }\n");
  const Genotype before = genotype;
  const ActiveRules once = Regulate(genotype, {});
  const ActiveRules twice = Regulate(genotype, {});
  CHECK(genotype == before);
  CHECK(once.joined == twice.joined);
}

}  // namespace
}  // namespace plsc
