#include "runtime/report/run_facts.h"

#include <unistd.h>

#include <catch2/catch.hpp>

#include "tests/runtime/store/stored_run.h"

namespace plsc {
namespace {

RunFacts FactsOf(const std::string& path) {
  Database database;
  REQUIRE_FALSE(database.Open(path, Database::Mode::kRead));
  const RunFacts facts = ReadFacts(database);
  CHECK_FALSE(database.TakeFailure());
  return facts;
}

}  // namespace

TEST_CASE("Facts are what the store was made of", "[run_facts]") {
  const test::Scratch scratch;
  const Experiment experiment = test::StoredExperiment();
  test::WriteRun(scratch / "run", 3);
  const RunFacts facts = FactsOf(scratch / "run");
  CHECK(facts.seed == std::to_string(experiment.seed));
  CHECK(facts.name == experiment.name);
  CHECK(facts.versions == ThisProgram());
  CHECK(facts.planned_generations == experiment.generations);
  CHECK(facts.planned_evaluations == Evaluations(experiment));
  CHECK(facts.evaluations >= experiment.population + 2 * experiment.offspring);
  RunStore store;
  REQUIRE_FALSE(store.OpenForReading(scratch / "run"));
  CHECK(facts.best == store.Status()->best);
  const StoredConstant friction{experiment.scenario.seasons[0].name,
                                "physics.friction", "1", ""};
  bool has_friction = false;
  for (const StoredConstant& constant : facts.constants)
    has_friction = has_friction || (constant.season == friction.season &&
                                    constant.name == friction.name);
  CHECK(has_friction);
  CHECK(facts.work.sessions == 0);
}

TEST_CASE("Sessions are added up, those that did not end apart",
          "[run_facts]") {
  const test::Scratch scratch;
  const std::string path = scratch / "run";
  {
    RunStore store;
    REQUIRE_FALSE(store.Create(path, test::StoredExperiment()));
    REQUIRE_FALSE(store.BeginSession({"2026-03-01T12:00:00Z", 2}));
    SessionEnd end;
    end.ended = "2026-03-01T13:00:00Z";
    end.how = "stopped";
    end.simulated = 30;
    end.looked_up = 10;
    end.seconds = 3600;
    end.cpu_seconds = 7000.5;
    REQUIRE_FALSE(store.EndSession(end));
    REQUIRE_FALSE(store.BeginSession({"2026-03-02T12:00:00Z", 2}));
    end.ended = "2026-03-02T12:00:10Z";
    end.seconds = 10;
    end.cpu_seconds = 19.5;
    REQUIRE_FALSE(store.EndSession(end));
    REQUIRE_FALSE(store.BeginSession({"2026-03-03T12:00:00Z", 2}));
    REQUIRE_FALSE(store.Close());
  }
  const WorkDone work = FactsOf(path).work;
  CHECK(work.sessions == 3);
  CHECK(work.open_sessions == 1);
  CHECK(work.first == "2026-03-01T12:00:00Z");
  CHECK(work.last == "2026-03-02T12:00:10Z");
  CHECK(work.hosts.size() == 1);
  CHECK(work.seconds == 3610);
  CHECK(work.cpu_seconds == 7020);
  CHECK(work.simulated == 60);
  CHECK(work.looked_up == 20);
  CHECK(FactsOf(path).best == 0);
}

}  // namespace plsc
