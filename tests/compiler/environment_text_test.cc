#include "compiler/environment_text.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

std::vector<State> States() {
  State inclined{"inclined", StateType::kBool, 0, 0, {}};
  State temperature{"temperature", StateType::kReal, -40, 60, {}};
  State ground{"ground", StateType::kEnum, 0, 0, {"dry", "wet"}};
  return {inclined, temperature, ground};
}

TEST_CASE("an environment reads every type of state", "[environment]") {
  const Source source("--env",
                      "ground=wet, inclined = True,temperature=-3.5e1");
  const auto environment = ParseEnvironment(source, States());
  REQUIRE(environment);
  CHECK(environment->values == std::vector<double>{1, -35, 1});
  CHECK(environment.diagnostics().empty());
}

TEST_CASE("an environment may name states that are not sensed",
          "[environment]") {
  const Source source("--env",
                      "inclined=False,temperature=0,ground=dry,raining=True");
  const auto environment = ParseEnvironment(source, States());
  REQUIRE(environment);
  REQUIRE(environment.diagnostics().size() == 1);
  CHECK(environment.diagnostics()[0].severity == Severity::kWarning);
  CHECK(environment.diagnostics()[0].code == Code::kUnsensedState);
  CHECK(source.text().substr(environment.diagnostics()[0].span.begin, 7) ==
        "raining");
}

TEST_CASE("an empty environment fits a genotype that senses nothing",
          "[environment]") {
  CHECK(ParseEnvironment(Source("--env", ""), {}));
  CHECK(ParseEnvironment(Source("--env", "  "), {}));
}

TEST_CASE("what is wrong with an environment is said", "[environment]") {
  struct Row {
    const char* why;
    const char* text;
    const char* code;  ///< of the first error
    const char* message;
  };
  const std::vector<Row> rows = {
      {"a state is missing", "inclined=True,ground=dry", "P2015",
       "no value for state 'temperature'"},
      {"all are missing", "", "P2015", "no value for state 'inclined'"},
      {"no assignment", "inclined", "P1115", "expected STATE=VALUE"},
      {"twice", "inclined=True,inclined=True,temperature=1,ground=dry", "P2015",
       "state 'inclined' is given twice"},
      {"another language's bool", "inclined=true,temperature=1,ground=dry",
       "P2006", "expected True or False for state 'inclined', found 'true'"},
      {"no number", "inclined=True,temperature=warm,ground=dry", "P2006",
       "expected a number in -40..60 for state 'temperature', found 'warm'"},
      {"out of range", "inclined=True,temperature=61,ground=dry", "P2015",
       "expected a number in -40..60 for state 'temperature', found '61'"},
      {"not finite", "inclined=True,temperature=nan,ground=dry", "P2006",
       "expected a number in -40..60 for state 'temperature', found 'nan'"},
      {"trailing text", "inclined=True,temperature=1C,ground=dry", "P2006",
       "expected a number in -40..60 for state 'temperature', found '1C'"},
      {"not a value of the enum", "inclined=True,temperature=1,ground=ice",
       "P2006", "expected one of dry, wet for state 'ground', found 'ice'"},
      {"a stray comma", "inclined=True,,temperature=1,ground=dry", "P1115",
       "expected STATE=VALUE"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const auto result = ParseEnvironment(Source("--env", row.text), States());
      REQUIRE_FALSE(result);
      CHECK(NumberOf(result.diagnostics()[0].code) == row.code);
      CHECK(result.diagnostics()[0].message == row.message);
    }
  }
}

}  // namespace
}  // namespace plsc
