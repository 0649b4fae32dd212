#include "runtime/study/study.h"

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <set>
#include <string>
#include <vector>

#include "tests/runtime/store/stored_run.h"
#include "tests/runtime/study/small_study.h"

namespace plsc {

namespace {

Study Parsed(const std::string& text) {
  const Source source("study.yaml", text);
  const auto study = ParseStudy(source);
  INFO(Render(study.diagnostics(), source));
  REQUIRE(study);
  return *study;
}

std::string Errors(const std::string& text) {
  const Source source("study.yaml", text);
  const auto study = ParseStudy(source);
  return study ? "" : Render(study.diagnostics(), source, 0);
}

}  // namespace

TEST_CASE("An experiment of a study is its base with its own keys", "[study]") {
  const Study study = Parsed(
      "plsc_study: 1\nname: seasons\nseed: 12\nrepetitions: 3\n"
      "base:\n  population: 10\n  mutation: 0.5\n"
      "  scenario: {seasons: [{name: flat}]}\n"
      "experiments:\n"
      "  plastic: {}\n"
      "  baseline: {encoding: baseline, population: 20}\n"
      "  tilted:\n    encoding: baseline\n"
      "    scenario: {seasons: [{terrain: {tilted: 5 deg}}]}\n");
  CHECK(study.name == "seasons");
  CHECK(study.seed == 12);
  CHECK(study.repetitions == 3);
  REQUIRE(study.experiments.size() == 3);
  const Experiment& plastic = study.experiments[0].experiment;
  CHECK(study.experiments[0].name == "plastic");
  CHECK(plastic.population == 10);
  CHECK(plastic.mutation == 0.5);
  CHECK(plastic.offspring == 100);  // nowhere: the default
  CHECK(plastic.genotype.encoding == Encoding::kPlasticoding);
  const Experiment& baseline = study.experiments[1].experiment;
  CHECK(baseline.population == 20);
  CHECK(baseline.mutation == 0.5);
  CHECK(baseline.genotype.encoding == Encoding::kBaseline);
  // A key is replaced as a whole: nothing of the base's scenario is left.
  const Scenario& tilted = study.experiments[2].experiment.scenario;
  REQUIRE(tilted.seasons.size() == 1);
  CHECK(tilted.seasons[0].name == "tilted");
}

TEST_CASE("A base's profile holds where an experiment names none", "[study]") {
  const auto study = ParseStudy(Source("s", R"(plsc_study: 1
base: {profile: swift}
experiments:
  a: {}
  b: {scenario: {seasons: [{}]}}
  c: {profile: paper}
  d: {scenario: {profile: paper, seasons: [{}]}}
)"));
  REQUIRE(study);
  std::vector<bool> with_ode;
  for (const StudyExperiment& one : study->experiments)
    with_ode.push_back(UsesOde(one.experiment.scenario));
  CHECK(with_ode == std::vector{false, false, true, true});
}

TEST_CASE("Without any other key a study repeats the paper's experiment",
          "[study]") {
  const Study study = Parsed("experiments: {paper: {}}");
  CHECK(study.seed == 1);
  CHECK(study.repetitions == 20);
  CHECK(study.experiments[0].experiment == Experiment{});
}

TEST_CASE("A printed study reads back equal", "[study]") {
  Study study = test::SmallStudy();
  study.name = "a: b";
  study.seed = 18446744073709551615u;
  study.experiments[0].experiment.scenario.seasons.pop_back();
  study.experiments[0].name = "2nd.try";
  const std::string text = PrintStudy(study);
  INFO(text);
  INFO(Errors(text));
  CHECK(Parsed(text) == study);
  CHECK(PrintStudy(Parsed(text)) == text);
  study.experiments[1].experiment.tournament = 3;
  CHECK(PrintStudy(study) != text);
}

TEST_CASE("The example studies are right", "[study]") {
  const auto read = [](const char* name) {
    return Parsed(
        test::ReadBytes(std::string(PLSC_SOURCE_DIR "/examples/") + name));
  };
  const Study paper = read("paper_study.yaml");
  CHECK(RunsOf(paper).size() == 4 * 20);
  // The paper's experiment is what all defaults are, but for the engine; and
  // its two halves.
  Experiment defaults;
  defaults.scenario = BothSeasons(Profile::kSwift);
  CHECK(paper.experiments[0].experiment == defaults);
  Experiment expected = defaults;
  expected.genotype.encoding = Encoding::kBaseline;
  CHECK(paper.experiments[1].experiment == expected);
  for (const std::size_t season : {0u, 1u}) {
    Experiment half = expected;
    half.scenario.seasons = {defaults.scenario.seasons[season]};
    half.scenario.name.clear();
    Experiment found = paper.experiments[2 + season].experiment;
    // Given in the paper's scenario and asked about by no clause.
    half.scenario.seasons[0].senses.clear();
    CHECK(found == half);
  }

  // The same four as published: by their keys and not by the paper's.
  const Study published = read("published_study.yaml");
  REQUIRE(published.experiments.size() == paper.experiments.size());
  Experiment habits;
  habits.variation.insertion = InsertionPoint::kBeforeEnd;
  habits.variation.removal = Removal::kByValue;
  habits.inheritance = Inheritance::kJoined;
  habits.scenario = PublishedScenario();
  habits.trials.own_lives = true;
  habits.trials.noise.start_height = 30e-6;
  CHECK(published.experiments[0].experiment == habits);
  for (std::size_t i = 0; i < 4; ++i) {
    const Experiment& one = published.experiments[i].experiment;
    CHECK(published.experiments[i].name == paper.experiments[i].name);
    CHECK(one.variation == habits.variation);
    CHECK(one.inheritance == Inheritance::kJoined);
    CHECK(one.trials == habits.trials);
    CHECK(one.scenario.controller == ControllerMode::kOpenLoop);
  }
  CHECK(published.experiments[3].experiment.scenario.seasons[0].physics ==
        habits.scenario.seasons[1].physics);

  const Study small = read("small_study.yaml");
  REQUIRE(small.experiments.size() == paper.experiments.size());
  for (std::size_t i = 0; i < small.experiments.size(); ++i)
    CHECK(small.experiments[i].name == paper.experiments[i].name);
}

TEST_CASE("Mistakes in a study are shown where they are, and once", "[study]") {
  struct Row {
    const char* why;
    const char* text;
    std::vector<const char*> parts;
  };
  const std::vector<Row> rows = {
      {"no experiments",
       "name: empty\n",
       {"expected the key 'experiments' here"}},
      {"an empty map of them",
       "experiments: {}\n",
       {"expected at least one experiment", "study.yaml:1:14"}},
      {"a list of them",
       "experiments: [plastic]\n",
       {"expected a map from names to experiments, found a list"}},
      {"an experiment without keys",
       "experiments:\n  plastic:\n",
       {"expected keys of an experiment ({} for none), found nothing"}},
      {"an unknown key of the study",
       "experiments: {a: {}}\nrepetition: 3\n",
       {"unknown key 'repetition'", "did you mean 'repetitions'?"}},
      {"a mistake in the base",
       "base: {population: 1}\nexperiments: {a: {}, b: {}}\n",
       {"study.yaml:1:20", "expected a whole number of 2 to 100000"}},
      {"an unknown key in the base",
       "base:\n  popullation: 9\nexperiments: {a: {}, b: {}}\n",
       {"study.yaml:2:3", "unknown key 'popullation'"}},
      {"a mistake in one experiment",
       "experiments:\n  a: {}\n  b: {mutation: 80}\n",
       {"study.yaml:3:17", "at least 0 and at most 1, found 80"}},
      {"a mistake in one experiment's scenario",
       "experiments:\n  a: {scenario: {seasons: [{duration: 5 kg}]}}\n",
       {"expected a time in s, ms or min, found 'kg'"}},
      {"a state that the base's seasons do not answer",
       "base: {scenario: {seasons: [{}]}}\nexperiments: {a: {states: [hot]}}\n",
       {"season 'flat': expected True or False for state 'hot'"}},
      {"a seed of one experiment",
       "experiments: {a: {seed: 3}}\n",
       {"'seed' is not for experiments of a study", "study.yaml:1:19"}},
      {"a name in the base",
       "base: {name: x}\nexperiments: {a: {}}\n",
       {"'name' is not for experiments of a study"}},
      {"a name that is no folder's",
       "experiments: {a/b: {}}\n",
       {"expected a name of letters", "found 'a/b'"}},
      {"a hidden folder", "experiments: {.a: {}}\n", {"found '.a'"}},
      {"the same name twice",
       "experiments: {a: {}, a: {}}\n",
       {"'a' is given twice"}},
      {"no repetitions", "repetitions: 0\nexperiments: {a: {}}\n", {"found 0"}},
      {"a newer format",
       "plsc_study: 2\nexperiments: {a: {}}\n",
       {"expected 1, found 2"}},
      {"not YAML", "experiments: {\n", {"this is not YAML"}}};
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const std::string errors = Errors(row.text);
      INFO(errors);
      for (const char* part : row.parts) {
        CAPTURE(part);
        const std::size_t first = errors.find(part);
        REQUIRE(first != std::string::npos);
        CHECK(errors.find(part, first + 1) == std::string::npos);
      }
    }
  }
}

TEST_CASE("Runs are all repetitions of one experiment after the other",
          "[study]") {
  const Study study = test::SmallStudy();
  std::vector<std::string> names;
  for (const StudyRun& run : RunsOf(study))
    names.push_back(RunName(study, run));
  CHECK(names == std::vector<std::string>{"plastic/1", "plastic/2",
                                          "baseline/1", "baseline/2"});
}

TEST_CASE("All runs have seeds of their own, which are always the same",
          "[study]") {
  Study study = test::SmallStudy();
  study.repetitions = 1000;
  std::set<std::uint64_t> seeds;
  for (study.seed = 1; study.seed <= 3; ++study.seed)
    for (const StudyRun& run : RunsOf(study)) seeds.insert(SeedOf(study, run));
  CHECK(seeds.size() == 3 * 2 * 1000);

  // Filed: a change would make other runs of every study.
  study.seed = 1;
  CHECK(SeedOf(study, {0, 1}) == 6795328262505675354u);
  CHECK(SeedOf(study, {1, 20}) == 7956397265350955629u);

  const std::uint64_t before = SeedOf(study, {1, 2});
  study.name = "renamed";
  study.repetitions = 5;
  study.experiments.erase(study.experiments.begin());
  CHECK(SeedOf(study, {0, 2}) == before);
}

TEST_CASE("A run's experiment has the run's name and seed", "[study]") {
  Study study = test::SmallStudy();
  const Experiment experiment = ExperimentOf(study, {1, 2});
  CHECK(experiment.name == "small baseline/2");
  CHECK(experiment.seed == SeedOf(study, {1, 2}));
  CHECK(experiment.genotype.encoding == Encoding::kBaseline);
  study.name.clear();
  CHECK(ExperimentOf(study, {1, 2}).name == "baseline/2");
}

TEST_CASE("A study of too many runs is refused", "[study]") {
  const auto first = [](int experiments, const std::string& head) {
    std::string text = head + "experiments:\n";
    for (int i = 0; i < experiments; ++i)
      text += "  e" + std::to_string(i) + ": {}\n";
    const Source source("test.yaml", "plsc_study: 1\n" + text);
    const auto study = ParseStudy(source);
    return study ? "" : study.diagnostics()[0].message;
  };
  CHECK(first(20'000, "repetitions: 10000\n") ==
        "a study has at most 1000000 runs; 20000 experiments of 10000 "
        "repetitions are 200000000");
  CHECK(first(100, "repetitions: 10000\n").empty());
  // Aliases: a short text, and more than memory holds.
  std::string base = "base:\n  a0: &a0 [1, 1]\n";
  for (int i = 1; i <= 40; ++i)
    base += fmt::format("  a{0}: &a{0} [*a{1}, *a{1}]\n", i, i - 1);
  CHECK(first(2, base).find("share a base") != std::string::npos);
}

}  // namespace plsc
