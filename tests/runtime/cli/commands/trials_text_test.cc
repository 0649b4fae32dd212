// The trials of a robot in `plsc show`, and what commands do with a run that
// has some.

#include "runtime/cli/commands/trials_text.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "runtime/store/result_dump.h"
#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

using Json = nlohmann::json;
using test::RunPlsc;

const char* const kTried = R"(plsc_experiment: 1
name: tried
profile: swift
population: 6
offspring: 6
generations: 3
trials: 3
trials_fitness: median
noise: {start_height: 30 um, motor: 2 deg, inclination: 1 deg}
scenario:
  seasons:
    - {name: flat, terrain: flat, duration: 1 s}
    - {name: hill, terrain: {tilted: 5 deg}, duration: 1 s}
)";

std::string DumpOf(const std::string& path) {
  const auto dump = DumpResults(path);
  REQUIRE(dump);
  return *dump;
}

TEST_CASE("trials are shown with how they were disturbed", "[trials_text]") {
  StoredTrial fine;
  fine.fitness = 0.0123;
  fine.disturbance.lift = 12.34e-6;
  fine.disturbance.friction = 0.9;
  StoredTrial broken;
  broken.outcome = Outcome::kUnstable;
  broken.reason = "torn";
  broken.disturbance.shift_x = 0.01;
  CHECK(cli::TrialsText(Experiment{}, {{fine, broken}}) ==
        "\ntrials in flat, by fitness (drawn is the first):\n"
        "    1    1.230 cm/s  lift 12.3 um, friction 90.0 %\n"
        "    2     none       shift 1 0 cm; unstable (torn)\n");
  CHECK(cli::TrialsText(Experiment{}, {}).empty());
}

TEST_CASE("a run with trials is shown, replayed and reported",
          "[trials_text]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("e.yaml", kTried);
  const std::string path = folder / "run.sqlite";
  CHECK_THAT(RunPlsc({"check", file}).out,
             Catch::Contains(
                 ", 3 trials a robot (fitness: median), noise: start_height "));
  REQUIRE(
      RunPlsc({"evolve", file, "-o", path, "--quiet", "--jobs", "1"}).exit ==
      0);
  CHECK_THAT(
      RunPlsc({"show", path, "--verify"}).out,
      Catch::Contains("\nlives: 3 trials a robot (fitness: median), noise: "));
  const Json run = Json::parse(RunPlsc({"show", path, "--format", "json"}).out);
  CHECK_THAT(run["lives"].get<std::string>(),
             Catch::Contains("3 trials a robot"));
  const Json one =
      Json::parse(RunPlsc({"show", path, "best", "--format", "json"}).out);
  REQUIRE(one["trials"].size() == 2);
  for (std::size_t season = 0; season < 2; ++season) {
    std::vector<double> fitnesses;
    for (const Json& trial : one["trials"][season]) {
      fitnesses.push_back(trial["fitness"]);
      CHECK(trial["lift"] > 0);
      CHECK(trial["lift"] < 30e-6);
    }
    REQUIRE(fitnesses.size() == 3);
    std::sort(fitnesses.begin(), fitnesses.end());
    CHECK(one["seasons"][season]["fitness"] == fitnesses[1]);
  }
  const std::string text = RunPlsc({"show", path, "best"}).out;
  CHECK_THAT(text, Catch::Contains("trials in hill, by fitness (drawn is the "
                                   "first):\n    1 "));
  const auto replayed = RunPlsc({"replay", path, "--all"});
  INFO(replayed.out);
  CHECK(replayed.exit == 0);
  // The life that is simulated again is the first that is stored.
  const auto again = RunPlsc({"simulate", path, "best", "--format", "json"});
  CHECK(Json::parse(again.out.substr(0, again.out.find('\n')))["state_hash"] ==
        one["seasons"][0]["state_hash"]);
  const Json report =
      Json::parse(RunPlsc({"report", path, "--format", "json"}).out);
  CHECK(report["experiments"][0]["lives"] == run["lives"]);
  std::string told;
  for (const Json& one_key : report["differences"])
    told += one_key["key"].get<std::string>() + " ";
  CHECK_THAT(told, Catch::Contains("trials trials_fitness noise "));
}

TEST_CASE("a cache changes no run with trials", "[trials_text]") {
  const test::TemporaryFolder folder;
  for (const char* own : {"False", "True"}) {
    const std::string file = folder.Write(
        "e.yaml", kTried + std::string("own_lives: ") + own + "\n");
    const std::string name = folder / own;
    const std::string cache = folder / "cache";
    REQUIRE(RunPlsc({"evolve", file, "-o", name + "1", "--quiet"}).exit == 0);
    for (const char* time : {"2", "3"})
      REQUIRE(RunPlsc({"evolve", file, "-o", name + time, "--quiet", "--cache",
                       cache, "--jobs", time})
                  .exit == 0);
    const std::string alone = DumpOf(name + "1");
    CHECK(DumpOf(name + "2") == alone);
    CHECK(DumpOf(name + "3") == alone);
  }
}

}  // namespace
}  // namespace plsc
