#include "runtime/compare/golden.h"

#include <catch2/catch.hpp>

#include "compiler/environment_text.h"
#include "tests/runtime/develop/compile_text.h"

namespace plsc {
namespace {

Observation ObserveOrFail(const Genotype& genotype,
                          const NamedEnvironment& environment) {
  const auto observation = Observe(genotype, environment);
  REQUIRE(observation);
  return *observation;
}

TEST_CASE("Observe names every module, node and edge", "[golden]") {
  const Genotype genotype = test::Robot(
      "sense inclined: bool\niterations 1\n"
      "rule C -> if inclined = True then { C add_left A1(0.5, 2.0, 3.0, 1.0) "
      "move_left add_front B move_left T(0.25) add_edge(0.5) }\n"
      "rule B -> { T(0.125) }\n");
  const Observation seen = ObserveOrFail(genotype, {"tilted", {{1}}});
  CHECK(seen.senses == "inclined=True");
  CHECK(seen.active_rules == std::vector<int>{1, 2});
  CHECK(seen.string.symbols.size() == 9);
  CHECK(seen.string.length == 9);
  CHECK(seen.string.hash.empty());
  CHECK(seen.string.symbols[2] == "A1(0.5, 2, 3, 1)");
  REQUIRE(seen.robot);
  REQUIRE(seen.robot->modules.size() >= 3);
  CHECK(seen.robot->modules[0] ==
        GoldenModule{"1", "C", "", "", GoldenCell{0, 0}, "front", 0});
  CHECK(seen.robot->modules[1] ==
        GoldenModule{"2", "A1", "1", "left", GoldenCell{-1, 0}, "left", 90});
  REQUIRE(!seen.robot->nodes.empty());
  CHECK(seen.robot->nodes[0] == GoldenNode{"node1", "2", true, 0.5, 2, 3, 1});
  CHECK(seen.robot->body_descriptors.size() == 20);
  CHECK(seen.robot->brain_descriptors.size() == 11);
}

TEST_CASE("an environment written as an assignment says what it means once",
          "[golden]") {
  const Genotype genotype =
      test::Robot("sense hot: bool\nrule C -> { C add_front B }\n");
  CHECK(ObserveOrFail(genotype, {"hot=True", {{1}}}).senses.empty());
  CHECK(ObserveOrFail(genotype, {"oven", {{1}}}).senses == "hot=True");
}

TEST_CASE("strings of own alphabets are observed, and have no robot",
          "[golden]") {
  const Genotype genotype = test::Didactic(
      "iterations 3\nrule X -> { X Y }\nrule Y -> { Z a }\nrule Z -> { X Z "
      "}\n");
  const Observation seen = ObserveOrFail(genotype, {"any", {}});
  CHECK(!seen.robot);
  CHECK(seen.string.symbols ==
        std::vector<std::string>{"X", "Y", "Z", "a", "X", "Z", "a"});
}

TEST_CASE("of a long string the first symbols and a hash are kept",
          "[golden]") {
  const auto observe = [](const std::string& production) {
    return ObserveOrFail(
        test::Didactic("iterations 10\nrule X -> { X X }\nrule Y -> " +
                       production),
        {"any", {}});
  };
  const Observation first = observe("{ a }");
  CHECK(first.string.length == 1024);
  CHECK(first.string.symbols.size() == kGoldenSymbols);
  CHECK(first.string.hash.size() == 16);

  // Equal at the beginning, different behind what is written out.
  const auto tail = [](const char* last) {
    return ObserveOrFail(test::Didactic("iterations 11\nrule X -> { X X }\n"
                                        "rule Y -> { a }\n" +
                                        std::string(last)),
                         {"any", {}});
  };
  CHECK(tail("").string.hash != first.string.hash);
  CHECK(tail("").string.hash == tail("").string.hash);
}

TEST_CASE("what grows beyond the limit is not observed", "[golden]") {
  const Genotype genotype =
      test::Didactic("iterations 100\nrule X -> { X X }\n");
  CHECK(!Observe(genotype, {"any", {}}));
}

TEST_CASE("default environments are the file's, or all there are", "[golden]") {
  struct Row {
    const char* why;
    const char* items;
    std::vector<std::string> environments;
  };
  const std::vector<Row> rows = {
      {"nothing is sensed", "", {"any"}},
      {"the file names some",
       "sense hot: bool\nenvironment oven { hot = True }\n",
       {"oven"}},
      {"all combinations, the last state fastest",
       "sense hot: bool\nsense soil: { dry, wet }\n",
       {"hot=False,soil=dry", "hot=False,soil=wet", "hot=True,soil=dry",
        "hot=True,soil=wet"}},
      {"a real has too many values", "sense t: real in 0..1\n", {}},
      {"five bools are 32",
       "sense a: bool\nsense b: bool\nsense c: bool\nsense d: bool\n"
       "sense e: bool\n",
       {}},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const Program program =
          test::CompileText("plsc 1\ngenotype g\nalphabet plasticoding 1\n" +
                            std::string(row.items) + "rule C -> { C }\n");
      CHECK(DefaultEnvironments(program) == row.environments);
      for (const std::string& text : row.environments)
        if (text.find('=') != std::string::npos) {
          const Source source("test", text);
          CHECK(ParseEnvironment(source, program.genotype.states));
        }
    }
  }
  SECTION("four bools are just enough") {
    CHECK(DefaultEnvironments(
              test::CompileText(
                  "plsc 1\ngenotype g\nalphabet plasticoding 1\nsense a: bool\n"
                  "sense b: bool\nsense c: bool\nsense d: bool\nrule C -> { C "
                  "}\n"))
              .size() == kMaxGoldenCombinations);
  }
}

}  // namespace
}  // namespace plsc
