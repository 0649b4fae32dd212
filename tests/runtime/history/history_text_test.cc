#include "runtime/history/history_text.h"

#include "tests/runtime/develop/grown.h"

namespace plsc {
namespace {

TEST_CASE(
    "a history is told rule by rule, rewriting by rewriting, symbol by "
    "symbol",
    "[history_text]") {
  const auto grown = test::Grow(test::kTwoGenerations, Environment{{0}});
  CHECK(HistoryText(grown.view()) ==
        "rules:\n"
        "  active     rule 1 of C (always), robot.pls:3:1\n"
        "  not active rule 2 of C (if hot = True), robot.pls:4:1\n"
        "  active     rule 3 of B (always), robot.pls:5:1\n"
        "  active     rule 4 of T (if hot = False), robot.pls:6:1\n"
        "rewritings:\n"
        "  Iteration 0: C\n"
        "  Iteration 1: C B\n"
        "  Iteration 2: C B add_front A1(0.5, 2, 3, 4) mutate_amp(1)\n"
        "symbols:\n"
        "  1 C                 the core, where both turtles start\n"
        "  2 B                 not expressed (IV): slot-reference empty\n"
        "  3 add_front         slot-reference := front, used by A1 (symbol "
        "4)\n"
        "  4 A1(0.5, 2, 3, 4)  mounted as module 2 (A1) at the front of "
        "module 1 (C) by add_front (symbol 3); made node1\n"
        "  5 mutate_amp(1)     amplitude of node1 from 2 to 3\n");
}

TEST_CASE("an ancestry shows each line up to the axiom", "[history_text]") {
  const auto grown = test::Grow(test::kTwoGenerations, Environment{{0}});
  CHECK(AncestryText(grown.view(), grown.history.derivation.string()[3]) ==
        " --> robot.pls:5:23\n"
        "5 | rule B -> { add_front A1(0.5, 2, 3, 4) mutate_amp(1) }\n"
        "  |                       ^^^^^^^^^^^^^^^^ inserted in iteration 2 by "
        "rule 3 (B, always)\n"
        "in place of B\n"
        " --> robot.pls:3:15\n"
        "3 | rule C -> { C B }\n"
        "  |               ^ inserted in iteration 1 by rule 1 (C, always)\n"
        "in place of C, the axiom\n");
}

TEST_CASE("of a clause of several terms those that hold are named",
          "[history_text]") {
  const auto grown = test::Grow(
      "plsc 1 alphabet plasticoding 1\nsense hot: bool\n"
      "sense wet: bool\naxiom C iterations 1\n"
      "rule C -> if hot = True or wet = True and hot = False then { C B }\n",
      Environment{{0, 1}});
  const std::string text =
      AncestryText(grown.view(), grown.history.derivation.string()[1]);
  CHECK(text.find("  = holds: wet = True, hot = False\n") != std::string::npos);
  CHECK(text.find("in place of C, the axiom\n --> robot.pls:4:7\n") !=
        std::string::npos);
  CHECK(RuleText(grown.view().genotype, 0) ==
        "rule 1 (C, if hot = True or wet = True and hot = False)");
}

}  // namespace
}  // namespace plsc
