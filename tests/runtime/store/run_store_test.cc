#include "runtime/store/run_store.h"

#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <set>
#include <string>

#include "compiler/print.h"
#include "runtime/store/result_dump.h"
#include "tests/runtime/store/stored_run.h"

namespace plsc {

namespace {

using test::Recorder;
using test::RecordRun;
using test::Report;
using test::Scratch;
using test::StoredExperiment;

const Recorder& TheRun() {
  static const Recorder recorder = RecordRun(StoredExperiment());
  return recorder;
}

std::uint64_t Bits(double value) {
  return std::bit_cast<std::uint64_t>(value == 0 ? 0 : value);
}

template <typename Descriptors>
void CheckSameList(const Descriptors& a, const Descriptors& b) {
  const auto first = List(a), second = List(b);
  for (std::size_t i = 0; i < first.size(); ++i) {
    CAPTURE(first[i].name);
    CHECK(Bits(first[i].value) == Bits(second[i].value));
  }
}

void CheckSame(const SeasonResult& a, const SeasonResult& b) {
  CHECK(a.season == b.season);
  CHECK(a.profile == b.profile);
  CHECK(a.outcome == b.outcome);
  CHECK(a.reason == b.reason);
  CHECK(Bits(a.begin) == Bits(b.begin));
  CHECK(a.sensed == b.sensed);
  CHECK(a.inclination == b.inclination);
  CHECK(a.change == b.change);
  CHECK(a.change_reason == b.change_reason);
  CheckSameList(a.body, b.body);
  CheckSameList(a.brain, b.brain);
  CHECK(a.behaviour.is_valid == b.behaviour.is_valid);
  CheckSameList(a.behaviour, b.behaviour);
  CHECK(a.fitness == b.fitness);
  CHECK(a.state_hash == b.state_hash);
  CHECK(a.steps == b.steps);
  CHECK(a.solver_warnings == b.solver_warnings);
}

void CheckSame(const Evaluation& a, const Evaluation& b) {
  REQUIRE(a.seasons.size() == b.seasons.size());
  for (std::size_t i = 0; i < a.seasons.size(); ++i)
    CheckSame(a.seasons[i], b.seasons[i]);
}

void CheckSame(const Individual& a, const Individual& b) {
  CAPTURE(a.id);
  CHECK(a.id == b.id);
  CHECK(a.generation == b.generation);
  CHECK(a.heritage.parents == b.heritage.parents);
  CHECK(a.heritage.from_second == b.heritage.from_second);
  CHECK(a.heritage.mutation == b.heritage.mutation);
  CHECK(a.heritage.senses == b.heritage.senses);
  CHECK(a.genotype == b.genotype);
  CHECK(Print(a.genotype) == Print(b.genotype));
  CheckSame(a.evaluation, b.evaluation);
}

std::string DumpOf(const std::string& path) {
  auto dump = DumpResults(path);
  REQUIRE(dump);
  return *dump;
}

}  // namespace

TEST_CASE("A store gives back all that it was shown, bit for bit",
          "[run_store]") {
  const Scratch scratch;
  const Recorder& run = TheRun();
  RunStore store;
  REQUIRE(store.Create(scratch / "run.sqlite", StoredExperiment()) ==
          std::nullopt);
  REQUIRE(Report(run, store) == "");
  REQUIRE(store.Close() == std::nullopt);
  // Nothing else is left behind.
  CHECK(scratch.Files() == std::vector<std::string>{"run.sqlite"});

  RunStore again;
  REQUIRE(again.OpenForReading(scratch / "run.sqlite") == std::nullopt);
  CHECK(again.experiment() == StoredExperiment());
  CHECK(again.versions() == ThisProgram());
  REQUIRE(run.individuals.size() == 32);
  for (const Individual& one : run.individuals) {
    auto found = again.Find(one.id);
    REQUIRE(found);
    CheckSame(*found, one);
    auto evidence = again.EvidenceOf(one.id);
    REQUIRE(evidence);
    const auto& shown = run.evidence[static_cast<std::size_t>(one.id - 1)];
    REQUIRE(evidence->size() == shown.size());
    for (std::size_t i = 0; i < shown.size(); ++i) {
      CHECK((*evidence)[i].phenotype == shown[i].phenotype);
      CHECK((*evidence)[i].body == shown[i].body);
      CHECK((*evidence)[i].brain == shown[i].brain);
      CHECK((*evidence)[i].simulation == shown[i].simulation);
      CHECK((*evidence)[i].simulated.state_hash ==
            shown[i].simulated.state_hash);
      CHECK((*evidence)[i].simulated.inclination ==
            shown[i].simulated.inclination);
      // What is stored can be looked up instead of being simulated.
      const auto looked_up = again.Find(shown[i].simulation);
      REQUIRE(looked_up);
      CheckSameList(looked_up->behaviour, shown[i].simulated.behaviour);
      CHECK(looked_up->outcome == shown[i].simulated.outcome);
      CHECK(looked_up->reason == shown[i].simulated.reason);
      CHECK(looked_up->steps == shown[i].simulated.steps);
    }
  }
  CHECK_FALSE(again.Find(Key{1, 2}));
  CHECK(again.Find(33).error().text ==
        "'" + (scratch / "run.sqlite") + "' has no robot 33");
  auto status = again.Status();
  REQUIRE(status);
  CHECK(status->generations == 5);
  CHECK(status->evaluations == 32);
  CHECK(status->best == run.generations.back().best);
  CHECK(status->is_finished);
}

TEST_CASE("Result tables are equal whatever the order of evaluations",
          "[run_store]") {
  const Scratch scratch;
  for (int order = 0; order < 4; ++order) {
    const std::string path = scratch / std::to_string(order);
    RunStore store;
    REQUIRE(store.Create(path, StoredExperiment()) == std::nullopt);
    if (order % 2 == 1)
      REQUIRE(store.BeginSession({"2026-01-01T00:00:00Z", order}) ==
              std::nullopt);
    REQUIRE(Report(TheRun(), store, order) == "");
    REQUIRE(store.Close() == std::nullopt);
    CHECK(DumpOf(path) == DumpOf(scratch / "0"));
  }
  CHECK(DumpOf(scratch / "0").size() > 100000);
}

TEST_CASE("A run goes on where it was left", "[run_store]") {
  const Scratch scratch;
  const Recorder& run = TheRun();
  for (int generations = 0; generations <= 4; ++generations) {
    CAPTURE(generations);
    const std::string path = scratch / std::to_string(generations);
    test::WriteRun(path, generations);
    RunStore store;
    REQUIRE(store.Open(path) == std::nullopt);
    auto saved = store.Load();
    REQUIRE(saved);
    CHECK(saved->generations == generations);
    const std::size_t half = generations == 0 ? 4 : 3;
    CHECK(saved->evaluations ==
          static_cast<std::int64_t>(
              generations == 0 ? 4 : 8 + (generations - 1) * 6 + 3));
    REQUIRE(saved->evaluated.size() == half);
    for (const auto& [id, evaluation] : saved->evaluated)
      CheckSame(evaluation,
                run.individuals[static_cast<std::size_t>(id - 1)].evaluation);
    if (generations == 0) {
      CHECK(saved->population.empty());
    } else {
      const auto& record =
          run.generations[static_cast<std::size_t>(generations - 1)];
      REQUIRE(saved->population.size() == record.survivors.size());
      for (std::size_t i = 0; i < record.survivors.size(); ++i) {
        CHECK(saved->population[i].id == record.survivors[i]);
        CheckSame(
            saved->population[i],
            run.individuals[static_cast<std::size_t>(record.survivors[i] - 1)]);
        const auto place = std::find(record.pool.begin(), record.pool.end(),
                                     record.survivors[i]);
        CHECK(saved->counts[i] == record.counts[static_cast<std::size_t>(
                                      place - record.pool.begin())]);
      }
    }
  }
}

TEST_CASE("Who is born otherwise than before does not go on", "[run_store]") {
  const Scratch scratch;
  test::WriteRun(scratch / "run", 1);
  RunStore store;
  REQUIRE(store.Open(scratch / "run") == std::nullopt);
  const Recorder& run = TheRun();
  std::vector<Individual> born(run.individuals.begin() + 8,
                               run.individuals.begin() + 14);
  const std::string before = DumpOf(scratch / "run");
  CHECK(store.OnBirths(born, {}) == std::nullopt);
  SECTION("another genotype") {
    born[2].genotype.rules.front().production.push_back(
        born[2].genotype.rules.front().production.back());
  }
  SECTION("other parents") {
    born[2].heritage.parents = {1, 2};
  }
  SECTION("another mutation") {
    born[2].heritage.mutation = Mutation{};
  }
  SECTION("another generation") {
    born[2].generation = 3;
  }
  born[2].heritage.senses = {{"inclined", "True"}};
  const auto failure = store.OnBirths(born, {});
  REQUIRE(failure);
  CHECK(failure->text.find("robot 11 of") == 0);
  CHECK(failure->text.find("another version of the program") !=
        std::string::npos);
  // It can be used still, and nothing was changed.
  CHECK(store.Find(11));
  CHECK(DumpOf(scratch / "run") == before);
}

TEST_CASE("A simulation that ends otherwise than before is refused",
          "[run_store]") {
  const Scratch scratch;
  test::WriteRun(scratch / "run", 1);
  RunStore store;
  REQUIRE(store.Open(scratch / "run") == std::nullopt);
  Individual one = TheRun().individuals[13];
  auto evidence = TheRun().evidence[13];
  evidence[0].simulation = TheRun().evidence[0][0].simulation;
  evidence[0].simulated.steps += 1;
  one.evaluation.seasons[0].steps += 1;
  const auto failure = store.OnEvaluated(one, evidence);
  REQUIRE(failure);
  CHECK(failure->text.find("ended otherwise now") != std::string::npos);
  // A result that does not follow from its evidence is our own mistake.
  one.evaluation.seasons[0].steps += 1;
  CHECK(store.OnEvaluated(one, evidence));
}

TEST_CASE("What no worker could simulate is no simulation", "[run_store]") {
  const Scratch scratch;
  RunStore store;
  REQUIRE(store.Create(scratch / "run", StoredExperiment()) == std::nullopt);
  std::vector<Individual> born(TheRun().individuals.begin(),
                               TheRun().individuals.begin() + 8);
  Individual& one = born[0];
  std::vector<SeasonEvidence> evidence = TheRun().evidence[0];
  REQUIRE(store.OnBirths(born, {}) == std::nullopt);
  for (std::size_t i = 0; i < evidence.size(); ++i) {
    SeasonResult& result = one.evaluation.seasons[i];
    result.outcome = evidence[i].simulated.outcome = Outcome::kWorkerDied;
    result.reason = evidence[i].simulated.reason = "it died";
    result.fitness.reset();
    result.behaviour = evidence[i].simulated.behaviour = {};
    result.state_hash = evidence[i].simulated.state_hash = 0;
    result.steps = evidence[i].simulated.steps = 0;
    result.solver_warnings = evidence[i].simulated.solver_warnings = 0;
  }
  REQUIRE(store.OnEvaluated(one, evidence) == std::nullopt);
  CHECK_FALSE(store.Find(evidence[0].simulation));
  CheckSame(*store.Find(one.id), one);
  // So another robot of the same kind is simulated, and that is found.
  Individual twin = TheRun().individuals[0];
  twin.id = 2;
  REQUIRE(store.OnEvaluated(twin, TheRun().evidence[0]) == std::nullopt);
  CHECK(store.Find(evidence[0].simulation));
}

TEST_CASE("A lineage has everybody once, nearest first", "[run_store]") {
  const Scratch scratch;
  test::WriteRun(scratch / "run");
  RunStore store;
  REQUIRE(store.OpenForReading(scratch / "run") == std::nullopt);
  auto lineage = store.Lineage(32, 100);
  REQUIRE(lineage);
  CHECK(lineage->front().id == 32);
  CHECK(lineage->front().distance == 0);
  std::set<int> seen;
  for (std::size_t i = 0; i < lineage->size(); ++i) {
    const Ancestor& ancestor = (*lineage)[i];
    CHECK(seen.insert(ancestor.id).second);
    if (i > 0) CHECK(ancestor.distance >= (*lineage)[i - 1].distance);
    const Individual& one =
        TheRun().individuals[static_cast<std::size_t>(ancestor.id - 1)];
    CHECK(ancestor.heritage.parents == one.heritage.parents);
    CHECK(ancestor.fitnesses == FitnessesOf(one));
    for (const int parent : one.heritage.parents) {
      CAPTURE(parent);
      CHECK(std::any_of(lineage->begin(), lineage->end(),
                        [&](const Ancestor& a) { return a.id == parent; }));
    }
  }
  CHECK(store.Lineage(32, 1)->size() == 3);
  CHECK(store.Lineage(32, 0)->size() == 1);
  CHECK_FALSE(store.Lineage(99, 1));
}

TEST_CASE("A run is never overwritten", "[run_store]") {
  const Scratch scratch;
  test::WriteBytes(scratch / "run", "my data");
  RunStore store;
  CHECK(store.Create(scratch / "run", StoredExperiment()) ==
        "'" + (scratch / "run") +
            "' exists; a run is never overwritten: choose another name, or go "
            "on with --resume");
  CHECK(test::ReadBytes(scratch / "run") == "my data");
  CHECK(store.Create(scratch / "none/run", StoredExperiment()) ==
        "cannot create '" + (scratch / "none/run") +
            "': No such file or directory");
  CHECK(scratch.Files() == std::vector<std::string>{"run"});
}

TEST_CASE("Another version of the program does not go on", "[run_store]") {
  const Scratch scratch;
  Versions versions = ThisProgram();
  SECTION("program") {
    versions.plsc = "0.0.9";
  }
  SECTION("engine") {
    versions.ode = "0.17";
  }
  SECTION("compiler") {
    versions.compiler = "13";
  }
  SECTION("machine") {
    versions.machine = "abacus";
  }
  SECTION("arithmetic") {
    versions.results = 1;
  }
  RunStore store;
  REQUIRE(store.Create(scratch / "run", StoredExperiment(), versions) ==
          std::nullopt);
  REQUIRE(store.Close() == std::nullopt);
  const auto failure = store.Open(scratch / "run");
  REQUIRE(failure);
  CHECK(failure->text.find(versions.results == 1
                               ? "was made by other"
                               : "was begun with") != std::string::npos);
  // But it can be read.
  CHECK(store.OpenForReading(scratch / "run") == std::nullopt);
  CHECK(store.versions() == versions);
}

TEST_CASE("Sessions tell who worked on a run, beside its results",
          "[run_store]") {
  const Scratch scratch;
  RunStore store;
  REQUIRE(store.Create(scratch / "run", StoredExperiment()) == std::nullopt);
  const std::string before = DumpOf(scratch / "run");
  REQUIRE(store.BeginSession({"2026-01-01T00:00:00Z", 2}) == std::nullopt);
  REQUIRE(store.EndSession({"2026-01-01T00:01:00Z", "stopped", 2, 10, 8, 12, 60,
                            118.5}) == std::nullopt);
  CHECK(DumpOf(scratch / "run") == before);
}

TEST_CASE("A store is read while it is written", "[run_store]") {
  const Scratch scratch;
  RunStore writer;
  REQUIRE(writer.Create(scratch / "run", StoredExperiment()) == std::nullopt);
  RunStore reader;
  REQUIRE(reader.OpenForReading(scratch / "run") == std::nullopt);
  CHECK(reader.Status()->evaluations == 0);
  REQUIRE(Report(TheRun(), writer, 0, 2) == "");
  CHECK(reader.Status()->evaluations == 17);
  CHECK(reader.Load()->generations == 2);
  CHECK(DumpOf(scratch / "run").size() > 10000);
  REQUIRE(writer.Close() == std::nullopt);
  CHECK(reader.Status()->generations == 2);
}

}  // namespace plsc
