#include <catch2/catch.hpp>

#include "compiler/compile.h"
#include "runtime/develop/develop.h"
#include "runtime/develop/phenotype_json.h"
#include "tests/runtime/service/asked.h"

namespace plsc {
namespace {

using test::OrderedJson;

/// What `plsc develop --format json` prints.
std::string DevelopedText(const Genotype& genotype,
                          const Environment& environment) {
  const auto string = Derive(genotype, Regulate(genotype, environment));
  REQUIRE(string);
  if (!genotype.alphabet->is_built_in())
    return DevelopmentJson(genotype, environment, *string, nullptr);
  const Phenotype robot = Develop(genotype, *string);
  return DevelopmentJson(genotype, environment, *string, &robot);
}

TEST_CASE("develop gives what 'plsc develop' prints", "[service]") {
  for (const auto& [name, text] : test::ExampleTexts()) {
    INFO(name);
    const auto program = Compile(Source(name, text));
    REQUIRE(program);
    std::vector<NamedEnvironment> environments = program->environments;
    if (environments.empty()) environments.push_back({"any", {}});
    const std::string answer =
        test::AnsweredText({{"ask", "develop"}, {"text", text}});
    for (const NamedEnvironment& named : environments)
      CHECK(test::HoldsBytes(
          answer, "\"development\":" +
                      DevelopedText(program->genotype, named.environment)));
    CHECK(OrderedJson::parse(answer)["environments"].size() ==
          environments.size());
  }
}

TEST_CASE("environments are named, written, or those of the seasons",
          "[service]") {
  const std::string climber = test::ExampleText("climber.pls");
  const OrderedJson two =
      test::Answered({{"ask", "develop"},
                      {"text", climber},
                      {"environment", {"tilted", "inclined=False"}}});
  REQUIRE(two["environments"].size() == 2);
  CHECK(two["environments"][0]["name"] == "tilted");
  CHECK(two["environments"][0]["senses"] == "inclined=True");
  CHECK(two["environments"][1]["name"] == "inclined=False");

  const std::string unnamed =
      "plsc 1\nalphabet plasticoding 1\nsense inclined: bool\n"
      "sense night: bool\nrule C -> { C add_front B }\n"
      "rule C -> if inclined = True then { C add_left B }\n";
  CHECK(test::WordsOf({{"ask", "develop"}, {"text", unnamed}}) ==
        "which environment? the text names none, and the scenario does not "
        "give all that is sensed; say it as inclined=False,night=False");
  const OrderedJson seasons = test::Answered(
      {{"ask", "develop"},
       {"text", unnamed},
       {"scenario",
        "plsc_scenario: 1\nseasons:\n"
        "  - {name: day, terrain: flat, senses: {night: False}}\n"
        "  - {name: dusk, terrain: {tilted: 5 deg}, senses: {night: "
        "True}}\n"}});
  REQUIRE(seasons["environments"].size() == 2);
  CHECK(seasons["environments"][0]["senses"] == "inclined=False,night=False");
  CHECK(seasons["environments"][1]["name"] == "dusk");
  CHECK(seasons["environments"][1]["senses"] == "inclined=True,night=True");

  CHECK(test::WordsOf({{"ask", "develop"},
                       {"text", climber},
                       {"environment", "elsewhere"}}) != "");
}

}  // namespace
}  // namespace plsc
