#include <catch2/catch.hpp>

#include "compiler/compile.h"
#include "runtime/life/evaluation.h"
#include "runtime/life/season_json.h"
#include "runtime/scenario/scenario_yaml.h"
#include "tests/runtime/service/asked.h"

namespace plsc {
namespace {

using test::OrderedJson;

Scenario ShortLives() {
  return *ParseScenario(Source("s", test::ShortScenario()));
}

TEST_CASE("lives are those of 'plsc simulate'", "[service]") {
  for (const auto& [name, text] : test::ExampleTexts()) {
    const auto program = Compile(Source(name, text));
    REQUIRE(program);
    if (!program->genotype.alphabet->is_built_in()) continue;
    for (const EngineKind engine :
         {EngineKind::kOde, EngineKind::kArticulated}) {
      INFO(name);
      Scenario scenario = ShortLives();
      REQUIRE_FALSE(SetEngine(scenario, engine));
      const Evaluation lived = Evaluate(program->genotype, scenario);
      const std::string answer = test::AnsweredText(
          {{"ask", "live"},
           {"text", text},
           {"scenario", test::ShortScenario()},
           {"engine", engine == EngineKind::kOde ? "ode" : "articulated"}});
      CHECK(test::HoldsBytes(answer, EvaluationJson(program->genotype, lived)));
      const OrderedJson json = OrderedJson::parse(answer);
      REQUIRE(json["seasons"].size() == 2);
      CHECK(json["fitness"]["hill"] == json["seasons"][1]["fitness"]);
      CHECK_FALSE(json.contains("view"));
    }
  }
}

TEST_CASE("a life is recorded when that is asked for", "[service]") {
  const OrderedJson answer =
      test::Answered({{"ask", "live"},
                      {"name", "climber.pls"},
                      {"text", test::ExampleText("climber.pls")},
                      {"scenario", test::ShortScenario()},
                      {"record", true}});
  const OrderedJson& life = answer["view"]["lives"][0];
  CHECK(life["source"] == "climber.pls");
  CHECK(life["recording"]["seasons"].size() == 2);
  CHECK(life["recording"]["seasons"][1]["name"] == "hill");
}

TEST_CASE("who cannot live is told why", "[service]") {
  const std::string sensitive =
      "plsc 1\nalphabet plasticoding 1\nsense wet: bool\n"
      "rule C -> if wet = True then { C add_front B }\n";
  const OrderedJson answer =
      test::Answered({{"ask", "live"}, {"text", sensitive}});
  CHECK(answer["ok"] == false);
  CHECK(answer["diagnostics"].size() == 2);  // of both seasons
  CHECK(answer["diagnostics"][0]["file"] == "scenario.yaml");

  CHECK(test::WordsOf(
            {{"ask", "live"}, {"text", test::ExampleText("didactic.pls")}}) ==
        "alphabet 'didactic' has no bodies to simulate");
  const std::string gecko = test::ExampleText("gecko.pls");
  CHECK(test::WordsOf({{"ask", "live"}, {"text", gecko}, {"engine", "x"}}) ==
        "expected 'engine' to be one of ode, articulated");
  CHECK(test::WordsOf({{"ask", "live"},
                       {"text", gecko},
                       {"scenario", "plsc_scenario: 1\nsesons: []\n"}}) != "");
}

}  // namespace
}  // namespace plsc
