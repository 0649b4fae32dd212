#include "runtime/evolve/run_log.h"

#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "compiler/compile.h"
#include "compiler/print.h"
#include "tests/runtime/evolve/fake_run.h"

namespace plsc {

namespace {

using nlohmann::json;

/// A folder for one test, gone afterwards.
class Scratch {
 public:
  Scratch()
      : path_(std::filesystem::temp_directory_path() /
              ("plsc_run_log_test_" + std::to_string(getpid()))) {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directory(path_);
  }
  ~Scratch() { std::filesystem::remove_all(path_); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  std::string operator/(const std::string& name) const {
    return (path_ / name).string();
  }

 private:
  std::filesystem::path path_;
};

std::string ReadFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::vector<json> ReadLines(const std::string& path) {
  std::istringstream text(ReadFile(path));
  std::vector<json> lines;
  for (std::string line; std::getline(text, line);)
    lines.push_back(json::parse(line));
  return lines;
}

/// What went wrong; empty if nothing did.
std::string RunInto(const std::string& folder, const Experiment& experiment,
                    int jobs, Evaluator evaluate) {
  RunLog log;
  if (auto failure = log.Create(folder, experiment)) return *failure;
  EvolveOptions options;
  options.jobs = jobs;
  options.evaluate = std::move(evaluate);
  options.observers = {&log};
  const RunResult result = Evolve(experiment, options);
  const auto failure = log.Finish(result);
  return result.failure + failure.value_or("");
}

const std::vector<std::string> kFiles = {"run.json", "individuals.jsonl",
                                         "generations.jsonl", "best.pls"};

}  // namespace

TEST_CASE("A run folder has everything that the run was", "[run_log]") {
  const Scratch scratch;
  const std::string folder = scratch / "run";
  const Experiment experiment = test::SmallExperiment();
  REQUIRE(RunInto(folder, experiment, 2, test::Look).empty());

  const json run = json::parse(ReadFile(folder + "/run.json"));
  CHECK(run["plsc_run"] == 1);
  CHECK(run["seed"] == 1);
  CHECK(run["evaluations"] == 32);
  CHECK(run["seasons"] == json({"flat", "tilted"}));
  CHECK_FALSE(run["versions"]["plsc"].get<std::string>().empty());
  CHECK_FALSE(run["versions"]["ode"].get<std::string>().empty());
  const auto read =
      ParseExperiment(Source("run.json", run["experiment"].get<std::string>()));
  REQUIRE(read);
  CHECK(*read == experiment);
  const auto scenario =
      ParseScenario(Source("run.json", run["scenario"].get<std::string>()));
  REQUIRE(scenario);
  CHECK(*scenario == experiment.scenario);

  const std::vector<json> robots = ReadLines(folder + "/individuals.jsonl");
  REQUIRE(robots.size() == 32);
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const json& robot = robots[i];
    CHECK(robot["id"] == i + 1);
    CHECK(robot["parents"].size() == (i < 8 ? 0u : 2u));
    const auto program =
        Compile(Source("robot", robot["genotype"].get<std::string>()));
    REQUIRE(program);
    const Evaluation evaluation = test::Look(program->genotype);
    REQUIRE(robot["seasons"].size() == 2);
    CHECK(robot["seasons"][0]["season"] == "flat");
    CHECK(robot["seasons"][0]["fitness"] == *evaluation.seasons[0].fitness);
    if (!evaluation.seasons[1].fitness) {
      CHECK(robot["seasons"][1]["fitness"].is_null());
      CHECK(robot["seasons"][1]["outcome"] == "overlapping");
    }
  }

  const std::vector<json> generations =
      ReadLines(folder + "/generations.jsonl");
  REQUIRE(generations.size() == 5);
  CHECK(generations[0]["pool"].size() == 8);
  CHECK(generations[4]["pool"].size() == 14);
  CHECK(generations[4]["counts"].size() == 14);
  CHECK(generations[4]["survivors"].size() == 8);
  const auto best = generations[4]["best"].get<std::size_t>();
  CHECK(ReadFile(folder + "/best.pls") == robots[best - 1]["genotype"]);
}

TEST_CASE("Any number of workers writes the same bytes", "[run_log]") {
  const Scratch scratch;
  for (const char* jobs : {"1", "2", "3"})
    REQUIRE(RunInto(scratch / jobs, test::SmallExperiment(), std::stoi(jobs),
                    test::Look)
                .empty());
  for (const std::string& file : kFiles) {
    CAPTURE(file);
    const std::string one = ReadFile((scratch / "1/") + file);
    CHECK_FALSE(one.empty());
    CHECK(ReadFile((scratch / "2/") + file) == one);
    CHECK(ReadFile((scratch / "3/") + file) == one);
  }
}

TEST_CASE("A real run writes the same bytes for 1, 2 and 3 workers",
          "[run_log][slow]") {
  Experiment experiment;
  experiment.population = 6;
  experiment.offspring = 6;
  experiment.generations = 3;
  for (Season& season : experiment.scenario.seasons) season.duration = 2;
  const Scratch scratch;
  for (const char* jobs : {"1", "2", "3"})
    REQUIRE(
        RunInto(scratch / jobs, experiment, std::stoi(jobs), nullptr).empty());
  for (const std::string& file : kFiles) {
    CAPTURE(file);
    const std::string one = ReadFile((scratch / "1/") + file);
    CHECK_FALSE(one.empty());
    CHECK(ReadFile((scratch / "2/") + file) == one);
    CHECK(ReadFile((scratch / "3/") + file) == one);
  }
  // Robots were simulated, and some of them moved.
  int moved = 0;
  for (const json& robot : ReadLines(scratch / "1/individuals.jsonl"))
    for (const json& season : robot["seasons"])
      if (season["outcome"] == "completed" && season["fitness"] != -0.1)
        ++moved;
  CHECK(moved > 0);
}

TEST_CASE("A folder that exists is not touched", "[run_log]") {
  const Scratch scratch;
  const std::string folder = scratch / "run";
  std::filesystem::create_directory(folder);
  RunLog log;
  CHECK(log.Create(folder, test::SmallExperiment()) ==
        "'" + folder + "' exists; a run is never overwritten");
  CHECK(std::filesystem::is_empty(folder));
}

TEST_CASE("A folder that cannot be made is reported", "[run_log]") {
  const Scratch scratch;
  RunLog log;
  const std::string folder = scratch / "missing/run";
  CHECK(log.Create(folder, test::SmallExperiment()) ==
        "cannot create '" + folder + "': No such file or directory");
  std::ofstream(scratch / "file") << "text";
  RunLog other;
  CHECK(other.Create(scratch / "file", test::SmallExperiment()));
}

TEST_CASE("A disk that is full ends the run with its reason", "[run_log]") {
  const Scratch scratch;
  // The system refuses to let files grow beyond this, as a full disk would.
  signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small = {20'000, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string failure =
      RunInto(scratch / "run", test::SmallExperiment(), 1, test::Look);
  setrlimit(RLIMIT_FSIZE, &before);
  signal(SIGXFSZ, SIG_DFL);
  CHECK(failure == "cannot write to '" + (scratch / "run") +
                       "/individuals.jsonl': File too large");
}

}  // namespace plsc
