#include "tests/runtime/store/stored_run.h"

#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <numeric>
#include <sstream>

#include "runtime/life/simulated.h"

namespace plsc::test {

namespace {

Simulated LookClosely(const Phenotype& robot, const Season& season,
                      const Disturbance& disturbance) {
  Simulated seen = Look(robot, season, disturbance);
  seen.state_hash = ~NumberOf(robot);  // often above 2^63
  if (!seen.behaviour.is_valid) return seen;
  const double number = static_cast<double>(NumberOf(robot) >> 11);
  seen.behaviour.head_balance = 1 / (1 + std::sqrt(number));
  seen.behaviour.velocity = std::sin(number);
  // Stored as 0: -0 is the same number.
  seen.behaviour.displacement_velocity =
      robot.body.modules.size() % 2 ? -0.0 : 5e-324;
  seen.behaviour.contacts = 1e300 / 3;
  seen.behaviour.servo_error_median = std::abs(std::sin(number)) / 7;
  seen.behaviour.servo_error_worst = std::abs(std::cos(number)) / 3;
  seen.behaviour.core_turns = std::sqrt(number);
  seen.behaviour.final_x = -std::sqrt(number);
  seen.behaviour.energy = number / 3;
  // None, as where there are no targets.
  seen.behaviour.target_distance = std::numeric_limits<double>::quiet_NaN();
  seen.solver_warnings = static_cast<int>(NumberOf(robot) % 3);
  return seen;
}

std::vector<std::size_t> Order(std::size_t count, int order) {
  std::vector<std::size_t> places(count);
  std::iota(places.begin(), places.end(), std::size_t{0});
  if (order == 1) std::reverse(places.begin(), places.end());
  if (order > 1)
    std::sort(places.begin(), places.end(), [&](std::size_t a, std::size_t b) {
      const auto mixed = [&](std::size_t i) {
        return (i + 1) * 2654435761U % static_cast<std::size_t>(96 + order);
      };
      return std::pair(mixed(a), a) < std::pair(mixed(b), b);
    });
  return places;
}

}  // namespace

Scratch::Scratch() {
  std::string name =
      (std::filesystem::temp_directory_path() / "plsc_store_XXXXXX").string();
  REQUIRE(mkdtemp(name.data()) != nullptr);
  path_ = name;
}

Scratch::~Scratch() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::vector<std::string> Scratch::Files() const {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(path_))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

Experiment StoredExperiment() {
  Experiment experiment = SmallExperiment();
  experiment.name = "stored";
  experiment.seed = 0xfedcba9876543210U;  // more than an SQL integer holds
  experiment.genotype.states.push_back({"heat", StateType::kReal, -40, 60, {}});
  experiment.scenario.seasons[0].senses["heat"] = "30.5";
  experiment.scenario.seasons[1].senses["heat"] = "-1e-3";
  return experiment;
}

Recorder RecordRun(const Experiment& experiment) {
  Recorder recorder;
  EvolveOptions options;
  options.jobs = 1;
  options.simulate = LookClosely;
  options.observers = {&recorder};
  const RunResult result = Evolve(experiment, options);
  REQUIRE(result.failure.empty());
  return recorder;
}

std::string Report(const Recorder& recorder, RunStore& store, int order,
                   int generations) {
  MaybeFailure failure;
  for (std::size_t g = 0; g < recorder.births.size() && !failure; ++g) {
    const bool is_last = static_cast<int>(g) == generations;
    const std::vector<int>& ids = recorder.births[g];
    std::vector<Individual> born;
    for (const int id : ids) {
      born.push_back(recorder.individuals[static_cast<std::size_t>(id - 1)]);
      born.back().evaluation = {};
    }
    failure = store.OnBirths(born, {});
    const std::size_t count = is_last ? ids.size() / 2 : ids.size();
    for (const std::size_t i : Order(count, order)) {
      if (failure) break;
      const auto place = static_cast<std::size_t>(ids[i] - 1);
      failure = store.OnEvaluated(recorder.individuals[place],
                                  recorder.evidence[place]);
    }
    if (is_last || failure) break;
    failure = store.OnGeneration(recorder.generations[g]);
  }
  return failure.value_or("").text;
}

void WriteRun(const std::string& path, int generations) {
  static const Recorder recorder = RecordRun(StoredExperiment());
  static std::map<int, std::string> written;
  std::string& bytes = written[generations];
  if (!bytes.empty()) {
    WriteBytes(path, bytes);
    return;
  }
  RunStore store;
  REQUIRE(store.Create(path, StoredExperiment()) == std::nullopt);
  REQUIRE(Report(recorder, store, 0, generations).empty());
  REQUIRE(store.Close() == std::nullopt);
  bytes = ReadBytes(path);
}

void WriteTriedRun(const std::string& path) {
  Experiment experiment = StoredExperiment();
  experiment.trials.count = 2;
  experiment.trials.noise = {30e-6, 0.1, 0.2, 0.01, 0.05, 0.03, 0.25};
  RunStore store;
  REQUIRE(store.Create(path, experiment) == std::nullopt);
  REQUIRE(Report(RecordRun(experiment), store, 0, 3).empty());
  REQUIRE(store.Close() == std::nullopt);
}

std::string ReadBytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

void WriteBytes(const std::string& path, const std::string& bytes) {
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file << bytes;
}

}  // namespace plsc::test
