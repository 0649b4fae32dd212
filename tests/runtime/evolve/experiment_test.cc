#include "runtime/evolve/experiment.h"

#include <catch2/catch.hpp>
#include <string>
#include <tuple>
#include <vector>

#include "runtime/formula/read_formula.h"
#include "runtime/scenario/scenario_profile.h"

namespace plsc {

namespace {

std::string Errors(const std::string& text) {
  const Source source("test.yaml", text);
  const auto experiment = ParseExperiment(source);
  return experiment ? "" : Render(experiment.diagnostics(), source, 0);
}

/// Every field differs from its default.
Experiment Unusual() {
  Experiment experiment;
  experiment.name = "a: b";
  experiment.seed = 18446744073709551615u;
  experiment.robots = "gecko";
  experiment.population = 10;
  experiment.offspring = 20;
  experiment.generations = 3;
  experiment.mutation = 1.0 / 3;
  experiment.crossover = 0;
  experiment.tournament = 4;
  experiment.genotype = {Encoding::kBaseline,
                         {2, 20, true},
                         {{"null", StateType::kBool, 0, 0, {}},
                          {"temperature", StateType::kReal, -40, 60.5, {}},
                          {"ground", StateType::kEnum, 0, 0, {"sand", "wet"}}},
                         2,
                         3,
                         true,
                         5,
                         4,
                         0,
                         3};
  experiment.inheritance = Inheritance::kJoined;
  experiment.variation = {0.1, InsertionPoint::kBeforeEnd, Removal::kByValue};
  experiment.scenario.name = "other";
  experiment.scenario.seasons.pop_back();
  experiment.scenario.seasons[0].fitness = *ReadFormula("speed - energy");
  return experiment;
}

}  // namespace

TEST_CASE("Without any key an experiment is the paper's", "[experiment]") {
  const auto read = ParseExperiment(Source("e", "{}"));
  REQUIRE(read);
  CHECK(*read == Experiment{});
  CHECK(read->population == 100);
  CHECK(read->offspring == 100);
  CHECK(read->generations == 200);
  CHECK(read->mutation == 0.8);
  CHECK(read->crossover == 0.8);
  CHECK(read->tournament == 2);
  CHECK(read->genotype.development.iterations == 3);
  CHECK(read->genotype.development.max_modules == 15);
  CHECK(read->inheritance == Inheritance::kGenotype);
  CHECK(read->variation.clause_share == 0.25);
  CHECK(read->variation.insertion == InsertionPoint::kAnywhere);
  CHECK(read->variation.removal == Removal::kByPosition);
  CHECK(read->genotype.min_groups == 1);
  CHECK(read->genotype.max_groups == 4);
  CHECK(read->genotype.min_initial_terms == 1);
  CHECK_FALSE(read->genotype.max_initial_terms);
  CHECK(read->genotype.max_rules == 2);
  CHECK(read->genotype.max_terms == 2);
  CHECK(read->genotype.states.size() == 1);
  CHECK(read->genotype.states[0].name == "inclined");
  CHECK(read->scenario == PaperScenario());
  CHECK(Evaluations(*read) == 20000);
}

TEST_CASE("A printed experiment reads back equal", "[experiment]") {
  for (const Experiment& experiment : {Experiment{}, Unusual()}) {
    const std::string text = PrintExperiment(experiment);
    INFO(text);
    INFO(Errors(text));
    const auto read = ParseExperiment(Source("printed", text));
    REQUIRE(read);
    CHECK(*read == experiment);
    CHECK(PrintExperiment(*read) == text);
  }
}

TEST_CASE("A scenario of its own file is left to the caller", "[experiment]") {
  const auto read = ParseExperiment(
      Source("e", "scenario: seasons.yaml\nstates: [unheard_of]\n"));
  REQUIRE(read);
  CHECK(read->scenario_file == "seasons.yaml");
  Experiment same = *read;
  same.scenario_file.clear();
  CHECK(AreSame(*read, same));
  ++same.seed;
  CHECK_FALSE(AreSame(*read, same));
  const std::vector<Diagnostic> errors = CheckSenses(*read);
  REQUIRE(errors.size() == 2);
  CHECK(errors[0].message.find("season 'flat'") != std::string::npos);
  CHECK(errors[0].message.find("'unheard_of'") != std::string::npos);
}

TEST_CASE("A profile at the top holds for a scenario that names none",
          "[experiment]") {
  const auto scenario = [](const std::string& text) {
    const auto read = ParseExperiment(Source("e", text));
    REQUIRE(read);
    // What is printed needs no profile at its top.
    CHECK(*ParseExperiment(Source("p", PrintExperiment(*read))) == *read);
    return read->scenario;
  };
  const std::string top = "profile: swift\n";
  CHECK(scenario(top) == BothSeasons(Profile::kSwift));
  const Scenario without = scenario(top + "scenario: {seasons: [{}]}\n");
  CHECK(without.profile == Profile::kSwift);
  CHECK_FALSE(UsesOde(without));
  const Scenario own =
      scenario(top + "scenario: {profile: paper, seasons: [{}]}\n");
  CHECK(own.profile == Profile::kPaper);
  CHECK(UsesOde(own));
  const Scenario written =
      scenario(top + "scenario: {physics: {engine: ode}, seasons: [{}]}\n");
  CHECK(written.profile == Profile::kSwift);
  CHECK(UsesOde(written));
  CHECK(Errors("profile: swfit\n").find("did you mean 'swift'?") !=
        std::string::npos);
  // Whoever reads the file knows by which profile.
  CHECK(ParseExperiment(Source("e", top + "scenario: s.yaml\n"))
            ->scenario.profile == Profile::kSwift);
}

TEST_CASE("As published are the operators, too, if it is said at the top",
          "[experiment]") {
  const auto read = [](const std::string& yaml) {
    const auto experiment = ParseExperiment(Source("e", yaml));
    REQUIRE(experiment);
    // All is written out, so what was printed means the same for ever.
    const auto again =
        ParseExperiment(Source("e", PrintExperiment(*experiment)));
    REQUIRE(again);
    CHECK(*again == *experiment);
    return *experiment;
  };
  const auto habits = [](const Experiment& one) {
    return std::tuple(one.variation.insertion, one.variation.removal,
                      one.inheritance);
  };
  const auto papers = std::tuple(InsertionPoint::kAnywhere,
                                 Removal::kByPosition, Inheritance::kGenotype);
  const auto published = std::tuple(InsertionPoint::kBeforeEnd,
                                    Removal::kByValue, Inheritance::kJoined);
  const Experiment all = read("profile: published\n");
  CHECK(habits(all) == published);
  CHECK(all.scenario == PublishedScenario());
  CHECK(habits(read("profile: swift\n")) == papers);
  CHECK(habits(read("scenario: {profile: published, seasons: [{}]}\n"
                    "encoding: baseline\n")) == papers);
  CHECK(habits(read("profile: published\nencoding: baseline\n"
                    "scenario: {profile: paper, seasons: [{}]}\n")) ==
        published);
  const Experiment some =
      read("profile: published\ninsertion: anywhere\ninheritance: genotype\n");
  CHECK(habits(some) == std::tuple(InsertionPoint::kAnywhere, Removal::kByValue,
                                   Inheritance::kGenotype));
}

TEST_CASE("The largest population is one of the paper's genotypes",
          "[experiment]") {
  CHECK(Errors("population: 100000\noffspring: 100000\n").empty());
}

TEST_CASE("Mistakes in an experiment are shown where they are",
          "[experiment]") {
  struct Row {
    const char* why;
    const char* text;
    std::vector<const char*> parts;
  };
  const std::vector<Row> rows = {
      {"an unknown key",
       "popullation: 5\n",
       {"unknown key 'popullation'", "did you mean 'population'?"}},
      {"nobody to choose parents from",
       "population: 1\n",
       {"expected a whole number of 2 to 100000, found 1"}},
      {"a population beyond memory",
       "population: 1000000\n",
       {"expected a whole number of 2 to 100000, found 1000000",
        "held in memory", "test.yaml:1:13"}},
      {"as many children",
       "offspring: 100001\n",
       {"expected a whole number of 1 to 100000, found 100001"}},
      {"genotypes beyond memory",
       "max_rules: 1000\nmax_groups: 1000\npopulation: 5\n",
       {"105 robots of up to 25005000 symbols each are more than the 50000000 "
        "symbols that memory is meant for",
        "test.yaml:3:13", "'max_groups' smaller"}},
      {"no generation", "generations: 0\n", {"found 0"}},
      {"a fitness that asks for what there is not",
       "fitness: sped\n",
       {"no quantity is called 'sped'", "did you mean 'speed'?",
        "test.yaml:1:10"}},
      {"targets that are none",
       "fitness: -target_distance\n",
       {"there are no targets", "test.yaml:1:10"}},
      {"a percentage",
       "mutation: 80\n",
       {"expected at least 0 and at most 1, found 80"}},
      {"a percent sign", "mutation: 80%\n", {"without a unit, found '%'"}},
      {"an unknown inheritance",
       "inheritance: epigenetic\n",
       {"expected genotype or joined or senses, found 'epigenetic'"}},
      {"an unknown insertion",
       "insertion: end\n",
       {"expected anywhere or before_end, found 'end'"}},
      {"an unknown removal",
       "removal: value\n",
       {"expected by_position or by_value, found 'value'"}},
      {"a share above one",
       "clause_mutation: 1.5\n",
       {"expected at least 0 and at most 1, found 1.5"}},
      {"more groups at least than at most",
       "max_groups: 2\nmin_groups: 3\n",
       {"expected a whole number of 1 to 2, found 3", "test.yaml:2:13"}},
      {"more terms at first than ever",
       "max_terms: 2\nmax_initial_terms: 3\n",
       {"expected a whole number of 0 to 2, found 3"}},
      {"more terms at least than at most",
       "max_initial_terms: 1\nmin_initial_terms: 2\n",
       {"expected a whole number of 0 to 1, found 2"}},
      {"a word that is no number of terms",
       "max_initial_terms: max_rules\n",
       {"expected a whole number", "max_rules"}},
      {"an unknown encoding",
       "encoding: plastic\n",
       {"expected plasticoding or baseline, found 'plastic'"}},
      {"clauses without states",
       "states: []\n",
       {"expected at least one state", "write 'encoding: baseline'",
        "test.yaml:1:9"}},
      {"a state that is no name",
       "states: [2nd]\n",
       {"expected a state, found '2nd'"}},
      {"a word of the language",
       "states: [rule]\n",
       {"expected a state, found 'rule'"}},
      {"a state twice",
       "states: [inclined, inclined]\n",
       {"state 'inclined' is given twice", "test.yaml:1:20"}},
      {"a range without its end",
       "states: [{temperature: 5}]\n",
       {"expected a range or a list of values, found '5'"}},
      {"a range upside down",
       "states: [{temperature: 60..-40}]\n",
       {"expected a range from less to more"}},
      {"an enum of one",
       "states: [{ground: [wet]}]\n",
       {"expected at least two values"}},
      {"an enum that repeats itself",
       "states: [{ground: [wet, wet]}]\n",
       {"value 'wet' is given twice"}},
      {"two states in one item",
       "states: [{a: 0..1, b: 0..1}]\n",
       {"expected one state here"}},
      {"a state that no season answers",
       "states: [windy]\nscenario:\n  seasons: [{}]\n",
       {"season 'flat': expected True or False for state 'windy', found "
        "nothing",
        "test.yaml:3:3"}},
      {"mistakes of the scenario inside",
       "scenario:\n  seasons: [{duration: 5 kg}]\n  sedn: 1\n",
       {"expected a time in s, ms or min, found 'kg'", "unknown key 'sedn'"}},
      {"more robots than numbers",
       "generations: 1000000\noffspring: 100000\n",
       {"more than can be numbered", "test.yaml:1:14"}},
      {"a newer format", "plsc_experiment: 2\n", {"found 2"}},
      {"a name of robots with a blank",
       "robots: my robot\n",
       {"expected a name, found 'my robot'"}},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const std::string errors = Errors(row.text);
      for (const char* part : row.parts) {
        INFO(errors);
        CHECK(errors.find(part) != std::string::npos);
      }
    }
  }
}

// Not timed; each took minutes when it was read.
TEST_CASE("Lists of any length are refused at once", "[experiment]") {
  const auto list = [](const char* name) {
    std::string text;
    for (int i = 0; i < 100000; ++i)
      text += (i > 0 ? ", " : "") + std::string(name) + std::to_string(i);
    return text;
  };
  struct Row {
    const char* why;
    std::string text;
    std::string code;
    std::string message;
  };
  const std::vector<Row> rows = {
      {"states", "states: [" + list("s") + "]\n", "P3002",
       "a genotype has at most 1000 states, found 100000"},
      {"values", "states: [{g: [" + list("v") + "]}]\n", "P3002",
       "a state has at most 1000 values, found 100000"},
      {"seasons", "scenario: {seasons: [" + list("x") + "]}\n", "P5108",
       "a scenario has at most 1000 seasons, found 100000"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const Source source("test.yaml", "plsc_experiment: 1\n" + row.text);
      const auto read = ParseExperiment(source);
      REQUIRE_FALSE(read);
      CHECK(NumberOf(read.diagnostics()[0].code) == row.code);
      CHECK(read.diagnostics()[0].message == row.message);
    }
  }
}

}  // namespace plsc
