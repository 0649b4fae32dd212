// A stop is looked for at every stage of a run, so that it is found in time
// however large the population is; and whenever it comes, the run goes on as if
// it had never been left. The numbers of an experiment at their limits, too.

#include <catch2/catch.hpp>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "runtime/evolve/evolve.h"
#include "tests/runtime/evolve/fake_run.h"
#include "tests/runtime/workers/here.h"

namespace plsc {

namespace {

using test::Recorder;

/// Notes at which stage a stop is asked for, and asks for it while births are
/// noted as a store does.
class Stages : public Recorder {
 public:
  MaybeFailure OnBirths(const std::vector<Individual>& born,
                        const std::function<bool()>& should_stop) override {
    stage = "births";
    for (std::size_t i = 0; i < born.size(); ++i)
      if (should_stop()) return std::nullopt;
    stage = "evaluation";
    left = born.size();
    return Recorder::OnBirths(born, should_stop);
  }
  MaybeFailure OnEvaluated(const Individual& one,
                           const std::vector<SeasonEvidence>& its) override {
    if (--left == 0) stage = "selection";
    return Recorder::OnEvaluated(one, its);
  }
  MaybeFailure OnGeneration(const GenerationRecord& record) override {
    stage = "breeding";
    return Recorder::OnGeneration(record);
  }
  std::string stage = "breeding";

 private:
  std::size_t left = 0;
};

/// Large enough for every stage to look, of robots that are quickly told.
Experiment LargeExperiment() {
  Experiment experiment = test::SmallExperiment();
  experiment.population = 1100;
  experiment.offspring = 400;
  experiment.generations = 2;
  experiment.genotype.encoding = Encoding::kBaseline;
  experiment.genotype.max_groups = 1;
  experiment.genotype.development.iterations = 1;
  return experiment;
}

struct Ended {
  RunResult result;
  std::int64_t asked = 0;
  std::string stage;  // in which the stop came
};

/// Stops at the `last`-th time of asking.
Ended Live(const Experiment& experiment, Stages& seen, std::int64_t last,
           std::optional<SavedRun> saved = {}) {
  Ended ended;
  EvolveOptions options;
  options.make_workers = [](const Work& work) {
    return std::make_unique<test::Here>(work);
  };
  options.simulate = test::Look;
  options.observers = {&seen};
  options.saved = std::move(saved);
  options.should_stop = [&] {
    if (++ended.asked == last) ended.stage = seen.stage;
    return ended.asked >= last;
  };
  ended.result = Evolve(experiment, options);
  return ended;
}

SavedRun SavedOf(const RunResult& result, const Stages& seen) {
  SavedRun saved;
  saved.generations = result.generations;
  saved.population = result.population;
  saved.counts = result.counts;
  saved.evaluations = result.evaluations;
  for (const Individual& one : seen.individuals)
    if (one.id > 0 && one.generation == result.generations)
      saved.evaluated[one.id] = one.evaluation;
  return saved;
}

}  // namespace

TEST_CASE("Every stage finds a stop, and the run goes on as if never left",
          "[evolve]") {
  const Experiment experiment = LargeExperiment();
  constexpr std::int64_t kNever = INT64_MAX;
  Stages whole;
  const Ended straight = Live(experiment, whole, kNever);
  REQUIRE(straight.result.ending == Ending::kFinished);
  std::map<std::string, int> stages;
  constexpr int kStops = 9;
  for (int i = 1; i <= kStops; ++i) {
    CAPTURE(i);
    Stages seen;
    const std::int64_t last = straight.asked * i / (kStops + 1);
    const Ended left = Live(experiment, seen, last);
    CHECK(left.result.ending == Ending::kStopped);
    // Found at once: nobody asks again.
    CHECK(left.asked == last);
    ++stages[left.stage];
    const Ended rest =
        Live(experiment, seen, kNever, SavedOf(left.result, seen));
    CHECK(rest.result.ending == Ending::kFinished);
    CHECK(rest.result.evaluations == straight.result.evaluations);
    CHECK(seen.generations == whole.generations);
  }
  for (const char* stage : {"breeding", "births", "evaluation", "selection"}) {
    CAPTURE(stage);
    CHECK(stages[stage] > 0);
  }
}

// The largest are only begun.
TEST_CASE("An experiment's numbers at their limits are lived",
          "[evolve][limits]") {
  struct Row {
    const char* changes;
    bool is_finished = true;
  };
  const std::vector<Row> rows = {
      {"seed: 18446744073709551615"},
      {"mutation: 0\ncrossover: 0"},
      {"mutation: 5e-324\ncrossover: 1"},
      {"tournament: 1"},
      {"tournament: 1000\npopulation: 2\noffspring: 1"},
      {"clause_mutation: 0"},
      {"clause_mutation: 1"},
      {"iterations: 0"},
      {"iterations: 100\npopulation: 2\noffspring: 1"},
      {"max_modules: 1"},
      {"max_modules: 1000"},
      {"max_groups: 1000\nmin_groups: 1000\npopulation: 2\noffspring: 1"},
      {"max_rules: 1\nmax_terms: 1"},
      {"max_rules: 1000\npopulation: 2\noffspring: 1"},
      {"max_terms: 1000\nmin_initial_terms: 1000"},
      {"population: 2\noffspring: 1"},
      {"population: 100000\nencoding: baseline\nmax_groups: 1", false},
      {"offspring: 100000\npopulation: 2\nencoding: baseline\nmax_groups: 1",
       false},
      {"generations: 1000000\noffspring: 1", false},
  };
  for (const Row& row : rows) {
    INFO(row.changes);
    const std::string text(row.changes);
    std::string yaml = text + '\n';
    for (const char* usual :
         {"population: 3\n", "offspring: 2\n", "generations: 2\n"}) {
      const std::string key(usual, std::string_view(usual).find(' '));
      if (text.find(key) == std::string::npos) yaml += usual;
    }
    const Result<Experiment> experiment =
        ParseExperiment(Source("limits", yaml));
    REQUIRE(experiment);
    Recorder seen;
    EvolveOptions options;
    options.make_workers = [](const Work& work) {
      return std::make_unique<test::Here>(work);
    };
    options.simulate = test::Look;
    options.observers = {&seen};
    options.should_stop = [&] { return seen.evaluated.size() >= 10; };
    const RunResult result = Evolve(*experiment, options);
    CHECK(result.ending ==
          (row.is_finished ? Ending::kFinished : Ending::kStopped));
  }
}

}  // namespace plsc
