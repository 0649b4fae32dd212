#include "runtime/evolve/worker_request.h"

#include <catch2/catch.hpp>

#include "runtime/life/simulated.h"
#include "tests/runtime/evolve/fake_run.h"

namespace plsc {

namespace {

Genotype Robot() {
  Rng rng({31, 0, 0, Purpose::kInitialise});
  Genotype genotype = Initialise({}, rng);
  genotype.name = "robot_1";
  return genotype;
}

}  // namespace

TEST_CASE("A worker simulates the piece of the life that was sent",
          "[worker_request]") {
  const LifePlanner planner(PaperScenario(), test::Look);
  const Work work = WorkOf(planner);
  for (const Senses& inherited : {Senses{}, Senses{{"inclined", "True"}}}) {
    for (const LifePiece& piece : planner.Plan(Robot(), inherited)) {
      CAPTURE(piece.first, inherited.size());
      const std::string answer = work(RequestFor(Robot(), inherited, piece));
      const std::vector<Simulated> told = SimulatedOf({1, answer, ""}, 1);
      const std::vector<Simulated> own =
          planner.Simulate(Robot(), inherited, piece);
      REQUIRE(told.size() == 1);
      CHECK(told[0].state_hash == own[0].state_hash);
      CHECK(told[0].behaviour.displacement_velocity_hill ==
            own[0].behaviour.displacement_velocity_hill);
    }
  }
}

TEST_CASE("A worker needs only the experiment as it is printed",
          "[worker_request]") {
  Experiment experiment;
  experiment.scenario.seasons[0].duration = 0.5;
  experiment.scenario.seasons[1].duration = 0.5;
  const LifePlanner planner(experiment.scenario);
  const Work work = WorkFor(PrintExperiment(experiment));
  const LifePiece piece = planner.Plan(Robot(), {})[1];
  const std::vector<Simulated> told =
      SimulatedOf({1, work(RequestFor(Robot(), {}, piece)), ""}, 1);
  CHECK(told[0].state_hash ==
        planner.Simulate(Robot(), {}, piece)[0].state_hash);
  CHECK(told[0].state_hash != 0);
}

TEST_CASE("A worker lives a disturbed life to the same bits",
          "[worker_request]") {
  Experiment experiment;
  for (Season& season : experiment.scenario.seasons) season.duration = 0.5;
  Disturbance disturbance;
  disturbance.lift = 1.0 / 3e5;
  disturbance.motor = {0.2, ~std::uint64_t{0}};
  const Disturbances disturbances = {{}, disturbance};
  for (const EngineKind engine : {EngineKind::kOde, EngineKind::kArticulated}) {
    REQUIRE_FALSE(SetEngine(experiment.scenario, engine));
    const LifePlanner planner(experiment.scenario);
    const Work work = WorkFor(PrintExperiment(experiment));
    const LifePiece piece = planner.Plan(Robot(), {}, disturbances)[1];
    const std::string request = RequestFor(Robot(), {}, piece, disturbances);
    const Simulated told = SimulatedOf({1, work(request), ""}, 1)[0];
    CHECK(told.state_hash ==
          planner.Simulate(Robot(), {}, piece, disturbances)[0].state_hash);
    CHECK(told.state_hash !=
          planner.Simulate(Robot(), {}, piece)[0].state_hash);
  }
}

TEST_CASE("A death, or nonsense, is an outcome of every season",
          "[worker_request]") {
  for (const Reply& reply :
       {Reply{1, std::nullopt, "signal 11"}, Reply{1, "nonsense", ""}}) {
    const std::vector<Simulated> told = SimulatedOf(reply, 2);
    REQUIRE(told.size() == 2);
    CHECK(told[0].outcome == Outcome::kWorkerDied);
    CHECK(told[1].outcome == Outcome::kWorkerDied);
    CHECK_FALSE(told[1].reason.empty());
  }
}

TEST_CASE("Workers may take far longer than any robot needs",
          "[worker_request]") {
  Experiment experiment;
  // Two seasons of 50 s.
  CHECK(HangSeconds(experiment) == Approx(300 + 20 * 100));
  // What takes longer than it is lived may take so much longer.
  PhysicsOptions& physics = experiment.scenario.seasons[0].physics;
  physics.step = 1e-5;
  CHECK(HangSeconds(experiment) == Approx(300 + 20 * (25000 + 50)));
  physics.step = 0.005;
  physics.solver_iterations = 5000;
  CHECK(HangSeconds(experiment) == Approx(300 + 20 * (5000 + 50)));
  physics.solver_iterations = 50;
  // The cubes of ODE are not the other engine's.
  PhysicsOptions swift = physics;
  swift.engine = EngineKind::kArticulated;
  swift.max_direct_links = 1000;
  std::swap(physics, swift);
  CHECK(HangSeconds(experiment) == Approx(300 + 20 * 100));
  std::swap(physics, swift);
  // 2.6 s a step; measured are 1.7 s.
  physics.max_direct_links = 200;
  CHECK(HangSeconds(experiment) > 20 * 10000 * 1.7);
  physics.max_direct_links = 100000;
  experiment.scenario.max_links = 32;
  CHECK(HangSeconds(experiment) == Approx(300 + 20 * 100));
  experiment.scenario.seasons.resize(1);
  experiment.scenario.seasons[0].duration = 1;
  CHECK(HangSeconds(experiment) > 60);
}

}  // namespace plsc
