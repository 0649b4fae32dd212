#include "runtime/service/subject.h"

#include <catch2/catch.hpp>

#include "runtime/service/limits.h"
#include "runtime/service/refusal.h"

namespace plsc::service {
namespace {

using Fields = nlohmann::json;

constexpr const char* kTwo =
    "plsc 1\nalphabet plasticoding 1\n"
    "genotype one\nrule C -> { C }\n"
    "genotype two\nrule C -> { C add_front B }\n";

TEST_CASE("the first genotype is meant, or the one that is named",
          "[service]") {
  const auto name = [](Fields fields) {
    return SubjectOf(Request(std::move(fields))).genotype().name;
  };
  CHECK(name({{"text", kTwo}}) == "one");
  CHECK(name({{"text", kTwo}, {"genotype", "two"}}) == "two");
  CHECK_THROWS_WITH(
      name({{"text", kTwo}, {"genotype", "tow"}, {"name", "a.pls"}}),
      "a.pls has no genotype 'tow'; did you mean 'two'?");
  CHECK_THROWS_WITH(name({{"text", kTwo}, {"genotype", "elsewhere"}}),
                    "robot.pls has no genotype 'elsewhere'");
}

TEST_CASE("texts longer than their limits are refused", "[service]") {
  const std::string long_text(kMostTextBytes + 1, '#');
  CHECK_THROWS_WITH(TextOf(Request(Fields{{"text", long_text}})),
                    "'text' has 1048577 bytes, more than 1048576");
  CHECK_THROWS_AS(
      TextOf(Request(Fields{{"text", ""}, {"name", std::string(2000, 'n')}})),
      Refusal);
  CHECK_THROWS_AS(ScenarioOf(Request(Fields{{"scenario", long_text}})),
                  Refusal);
}

TEST_CASE("what grows beyond the limits is refused before it does",
          "[service]") {
  std::string rules = "rule C -> { C B }\nrule B -> {";
  for (int i = 0; i < 40; ++i) rules += " B";
  const auto refuse = [&](int iterations, std::size_t environments) {
    const Subject subject = SubjectOf(Request(Fields{
        {"text", "plsc 1\nalphabet plasticoding 1\niterations " +
                     std::to_string(iterations) + "\n" + rules + " }\n"}}));
    RefuseGrowth(subject,
                 std::vector<NamedEnvironment>(environments, {"any", {}}));
  };
  CHECK_NOTHROW(refuse(4, 1));  // C, 1 + 40 + 1600 + 64000
  CHECK_THROWS_WITH(refuse(4, 2),
                    "in any, 131284 symbols have been developed, more than "
                    "131072 of one request");
  try {
    refuse(100, 1);
    FAIL();
  } catch (const Refusal& refusal) {
    CHECK(std::string(refusal.what()).starts_with("P4001"));
    CHECK_FALSE(refusal.diagnostics().empty());
  }
}

TEST_CASE("a scenario that would take too long to feel is refused",
          "[service]") {
  std::string seasons;
  for (int i = 0; i < 60; ++i)
    seasons += "  - {name: s" + std::to_string(i) +
               ", terrain: flat, duration: 1 s, physics: {step: 0.01 ms}}\n";
  CHECK_THROWS_WITH(
      ScenarioOf(Request(Fields{
          {"scenario",
           "plsc_scenario: 1\nimu: {settling: 1 s}\nseasons:\n" + seasons}})),
      Catch::StartsWith("to settle before they feel the ground"));
  for (int i = 60; i < 70; ++i)
    seasons += "  - {name: s" + std::to_string(i) + ", terrain: flat}\n";
  CHECK_THROWS_WITH(
      ScenarioOf(Request(
          Fields{{"scenario", "plsc_scenario: 1\nseasons:\n" + seasons}})),
      "the scenario has 70 seasons, more than 64");
}

}  // namespace
}  // namespace plsc::service
