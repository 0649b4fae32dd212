#include "runtime/study/claim_yaml.h"

#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "runtime/study/study.h"

namespace plsc {

namespace {

std::string StudyText(const std::string& claims) {
  return R"(base: {profile: swift, generations: 40}
experiments:
  plastic: {}
  baseline: {encoding: baseline}
  level:
    scenario: {seasons: [{name: flat, terrain: flat, duration: 1 s}]}
)" + claims;
}

Result<Study> Read(const std::string& claims) {
  const std::string text = StudyText(claims);
  const Source source("s.yaml", text);
  return ParseStudy(source);
}

/// "6:5 expected ..." of all that is wrong.
std::vector<std::string> Wrong(const std::string& claims) {
  const std::string text = StudyText(claims);
  const Source source("s.yaml", text);
  std::vector<std::string> lines;
  const auto study = ParseStudy(source);
  for (const Diagnostic& one : study.diagnostics()) {
    const auto place = source.PositionOf(one.span.begin);
    lines.push_back(
        fmt::format("{}:{} {}", place.line - 6, place.column, one.message));
  }
  return lines;
}

}  // namespace

TEST_CASE("Claims of every kind are read", "[claim_yaml]") {
  const auto study = Read(R"(claims:
  faster in Flat:
    measure: Speed
    season: flat
    greater: [plastic, baseline]
    source: Fig. 3
  "calmer: on the slope":
    measure: head_balance
    of: best
    experiment: plastic
    less: [flat, tilted]
    family: balance
  as big: {measure: size, season: tilted, equal: [baseline, plastic]}
  the red line: {measure: speed, experiment: level, season: flat, value: 3.63 cm/s, over_runs: mean}
  shrinks: {measure: sensors reach, experiment: plastic, season: flat, minimum_before: 25}
)");
  REQUIRE(study);
  REQUIRE(study->claims.size() == 5);
  const Claim& first = study->claims[0];
  CHECK(first.name == "faster in Flat");
  CHECK(first.measure == "speed");
  CHECK(first.kind == ClaimKind::kGreater);
  CHECK(first.experiments == std::vector<std::string>{"plastic", "baseline"});
  CHECK(first.seasons == std::vector<std::string>{"flat"});
  CHECK(first.source == "Fig. 3");
  const Claim& second = study->claims[1];
  CHECK(second.measure == "balance");
  CHECK(second.of == ClaimOf::kBest);
  CHECK(second.seasons == std::vector<std::string>{"flat", "tilted"});
  CHECK(second.experiments == std::vector<std::string>{"plastic"});
  CHECK(second.family == "balance");
  CHECK(study->claims[3].value == 3.63);
  CHECK(study->claims[3].over_runs == OverRuns::kMean);
  CHECK(study->claims[4].minimum_before == 25);
  CHECK(study->claims[4].measure == "sensors_reach");

  const std::string printed = PrintStudy(*study);
  const auto again = ParseStudy(Source("again.yaml", printed));
  REQUIRE(again);
  CHECK(*again == *study);
  CHECK(PrintStudy(*again) == printed);
}

TEST_CASE("What is wrong with a claim is said at its place", "[claim_yaml]") {
  struct Row {
    const char* why;
    const char* claim;  // one, in braces
    const char* wrong;
  };
  const std::vector<Row> rows = {
      {"no kind", "{measure: size, season: flat}",
       "1:11 expected one of 'greater', 'less', 'equal', "
       "'value', 'minimum_before'"},
      {"an unknown measure",
       "{measure: sped, season: flat, greater: [plastic, baseline]}",
       "1:24 unknown measure 'sped'"},
      {"an unknown experiment",
       "{measure: speed, season: flat, greater: [plastik, baseline]}",
       "1:55 the study has no experiment 'plastik'"},
      {"an unknown season",
       "{measure: speed, season: flatt, greater: [plastic, baseline]}",
       "1:39 experiment 'plastic' has no season 'flatt'"},
      {"a season that one of the two lacks",
       "{measure: speed, season: tilted, greater: [plastic, level]}",
       "1:39 experiment 'level' has no season 'tilted'"},
      {"a course of a season that a static one lacks",
       "{measure: size, experiment: level, season: tilted, minimum_before: 9}",
       "1:57 experiment 'level' has no season 'tilted'"},
      {"itself", "{measure: speed, season: flat, greater: [plastic, plastic]}",
       "1:64 'plastic' is compared with itself"},
      {"one only", "{measure: speed, season: flat, greater: [plastic]}",
       "1:54 expected a list of two experiments"},
      {"a name in place of a list",
       "{measure: speed, experiment: plastic, less: flat}",
       "1:58 expected a list of two seasons"},
      {"two kinds",
       "{measure: speed, season: flat, greater: [plastic, baseline], "
       "equal: [plastic, baseline]}",
       "1:82 a claim has one of 'greater' and 'equal', not both"},
      {"neither season nor experiment",
       "{measure: speed, greater: [plastic, baseline]}",
       "1:11 expected 'season', to compare two experiments in it, or "
       "'experiment', to compare two of its seasons"},
      {"both",
       "{measure: speed, season: flat, experiment: plastic, less: [a, b]}",
       "1:11 expected 'season', to compare two experiments in it, or "
       "'experiment', to compare two of its seasons"},
      {"a value of no experiment", "{measure: size, season: flat, value: 3}",
       "1:11 expected 'experiment'"},
      {"a value without its unit",
       "{measure: speed, season: flat, experiment: level, value: 3.63}",
       "1:71 expected a number with its unit, cm/s, found '3.63'"},
      {"another unit",
       "{measure: speed, season: flat, experiment: level, value: 3 m/s}",
       "1:71 expected a number with its unit, cm/s, found '3 m/s'"},
      {"no number",
       "{measure: speed, season: flat, experiment: level, value: nan cm/s}",
       "1:71 expected a number with its unit, cm/s, found 'nan cm/s'"},
      {"too large a number",
       "{measure: balance, season: flat, experiment: level, value: 1e999}",
       "1:73 expected a number, found '1e999'"},
      {"over what, of no value",
       "{measure: size, season: flat, less: [plastic, baseline], "
       "over_runs: mean}",
       "1:82 'over_runs' is for claims of a value"},
      {"a minimum before the first step",
       "{measure: size, season: flat, experiment: level, minimum_before: 1}",
       "1:79 expected a whole number of 2 to 1000000000, found 1"},
      {"a minimum beyond the last generation",
       "{measure: size, season: flat, experiment: level, minimum_before: 40}",
       "1:79 experiment 'level' has 40 generations, 0 to 39"},
      {"an unknown key",
       "{measure: size, season: flat, less: [plastic, baseline], sauce: x}",
       "1:71 unknown key 'sauce'"},
      {"a word for a claim", "faster",
       "1:14 expected keys of a claim, found "
       "'faster'"},
  };
  for (const Row& row : rows) {
    INFO(row.why);
    const auto wrong = Wrong(fmt::format("claims: {{ a: {}}}\n", row.claim));
    REQUIRE(wrong.size() == 1);
    CHECK(wrong[0] == row.wrong);
  }
}

TEST_CASE("No claims, the same twice, and far too many are refused",
          "[claim_yaml]") {
  CHECK(Wrong("claims: {}\n") ==
        std::vector<std::string>{"1:9 expected at least one claim"});
  CHECK(Wrong("claims: []\n") ==
        std::vector<std::string>{
            "1:9 expected a map from what is claimed to keys, found a list"});
  const std::string claim =
      "{measure: size, season: flat, less: [plastic, "
      "baseline]}\n";
  CHECK(Wrong("claims:\n  a: " + claim + "  a: " + claim) ==
        std::vector<std::string>{"3:3 'a' is given twice"});
  CHECK(Wrong("claims:\n  a: " + claim + "  b: " + claim) ==
        std::vector<std::string>{"3:3 this claims what 'a' does"});
  std::string many = "claims:\n";
  for (int i = 0; i < 10'000; ++i) many += fmt::format("  c{}: {}", i, claim);
  CHECK(Wrong(many) == std::vector<std::string>{
                           "2:3 a study has at most 1000 claims, found 10000"});
}

TEST_CASE("Claims about a study that is wrong elsewhere tell only their own",
          "[claim_yaml]") {
  const std::string text =
      "experiments: {plastic: {encodin: baseline}}\n"
      "claims: {a: {measure: size, season: summer, less: [plastic, other]}}\n";
  const Source source("s.yaml", text);
  CHECK(ParseStudy(source).diagnostics().size() == 1);
}

TEST_CASE("Scenarios in files of their own are checked when they are there",
          "[claim_yaml]") {
  const std::string text =
      "experiments: {a: {scenario: x.yaml, generations: 9}, b: {scenario: "
      "x.yaml}}\n"
      "claims: {c: {measure: size, season: summer, less: [a, b]}}\n";
  const Source source("s.yaml", text);
  auto study = ParseStudy(source);
  REQUIRE(study);
  const auto problems = CheckClaims(study->claims, study->experiments);
  REQUIRE(problems.size() == 2);
  CHECK(problems[0].message ==
        "claim 'c': experiment 'a' has no season 'summer'");
  for (StudyExperiment& one : study->experiments)
    one.experiment.scenario.seasons[0].name = "summer";
  CHECK(CheckClaims(study->claims, study->experiments).empty());
}

TEST_CASE("A formula's fitness has no unit in which to claim its value",
          "[claim_yaml]") {
  const auto problems_of = [](const std::string& claim) {
    const Source source("s.yaml",
                        "plsc_study: 1\nrepetitions: 2\n"
                        "base: {fitness: speed - energy}\nexperiments: {a: {}, "
                        "b: {}}\nclaims:\n  c: {season: flat, " +
                            claim + "}\n");
    const auto study = ParseStudy(source);
    INFO(Render(study.diagnostics(), source));
    REQUIRE(study);
    return CheckClaims(study->claims, study->experiments);
  };
  const auto problems =
      problems_of("measure: fitness, experiment: a, value: 3 cm/s");
  REQUIRE(problems.size() == 1);
  CHECK(problems[0].message.find("no speed in cm/s") != std::string::npos);
  CHECK(problems_of("measure: speed, experiment: a, value: 3 cm/s").empty());
  CHECK(problems_of("measure: fitness, greater: [a, b]").empty());
}

}  // namespace plsc
