// What the evolver itself costs, without and with the physics. Reports;
// asserts nothing.
//
//   evolve_bench [--smoke]
//
// 1. A run of the paper's shape (100 + 100 robots, 200 generations) whose
//    simulations are stubbed: the coordinator's work a robot, its memory by
//    generation, the store's size and the time that writing it takes.
// 2. A small real run with 1 and with 2 workers: the efficiency of the second,
//    and the coordinator's share of all CPU time.
//
// A real run of the paper's size is measured by paper_run.py.

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include "runtime/develop/phenotype_json.h"
#include "runtime/evolve/evolve.h"
#include "runtime/life/simulated.h"
#include "runtime/store/run_store.h"

namespace plsc {
namespace {

double CpuSeconds(int who) {
  rusage usage{};
  getrusage(who, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) +
           1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double WallSeconds() {
  return std::chrono::duration<double>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

/// Resident memory of this process now, KiB.
long MemoryNow() {
  std::ifstream status("/proc/self/statm");
  long total = 0;
  long resident = 0;
  status >> total >> resident;
  return resident * sysconf(_SC_PAGESIZE) / 1024;
}

/// As if simulated: a number that differs between phenotypes.
Simulated Stub(const Phenotype& robot, const Season& season,
               const Disturbance& /*disturbance*/) {
  Simulated stub;
  const Key key = KeyOf(BodyJson(robot.body) + BrainJson(robot) + season.name);
  stub.behaviour.is_valid = true;
  stub.behaviour.displacement_velocity_hill =
      std::ldexp(static_cast<double>(key.low >> 11), -58);
  stub.behaviour.velocity = stub.behaviour.displacement_velocity_hill;
  stub.behaviour.displacement_velocity = stub.behaviour.velocity;
  stub.behaviour.head_balance = std::ldexp(static_cast<double>(key.high), -64);
  stub.state_hash = key.low;
  stub.steps = 10000;
  return stub;
}

/// Times what it passes on.
class Timed : public RunObserver {
 public:
  explicit Timed(RunObserver& inner) : inner_(inner) {}
  double seconds = 0;
  long memory_after_20 = 0;

  MaybeFailure OnBirths(const std::vector<Individual>& born,
                        const std::function<bool()>& should_stop) override {
    return Time([&] { return inner_.OnBirths(born, should_stop); });
  }
  MaybeFailure OnEvaluated(
      const Individual& one,
      const std::vector<SeasonEvidence>& evidence) override {
    return Time([&] { return inner_.OnEvaluated(one, evidence); });
  }
  MaybeFailure OnGeneration(const GenerationRecord& record) override {
    if (record.generation == 19) memory_after_20 = MemoryNow();
    if (record.generation % 20 == 19)
      fmt::print("  generation {:>3}: coordinator's memory {:>6} KiB\n",
                 record.generation + 1, MemoryNow());
    return Time([&] { return inner_.OnGeneration(record); });
  }

 private:
  template <typename Work>
  MaybeFailure Time(const Work& work) {
    const double begin = CpuSeconds(RUSAGE_SELF);
    MaybeFailure failure = work();
    seconds += CpuSeconds(RUSAGE_SELF) - begin;
    return failure;
  }
  RunObserver& inner_;
};

void ReportStubbed(const Experiment& experiment, const std::string& path) {
  RunStore store;
  if (const auto failure = store.Create(path, experiment)) {
    fmt::print("{}\n", failure->text);
    return;
  }
  Timed timed(store);
  EvolveOptions options;
  options.simulate = Stub;
  options.caches = {&store};
  options.observers = {&timed};
  const double cpu = CpuSeconds(RUSAGE_SELF);
  const double wall = WallSeconds();
  const RunResult result = Evolve(experiment, options);
  const double own = CpuSeconds(RUSAGE_SELF) - cpu;
  const auto robots = static_cast<double>(result.evaluations);
  fmt::print(
      "stubbed: {} robots in {:.1f} s ({:.0f}/s), known already {:.1f} % of "
      "seasons\n",
      result.evaluations, WallSeconds() - wall, robots / (WallSeconds() - wall),
      100.0 * static_cast<double>(result.counts_of_work.looked_up) /
          (2 * robots));
  fmt::print("  coordinator {:.3f} ms CPU a robot, of it the store {:.3f} ms\n",
             1e3 * own / robots, 1e3 * timed.seconds / robots);
  fmt::print("  memory after generation 20: {} KiB, at the end {} KiB\n",
             timed.memory_after_20, MemoryNow());
  store.Close();
  fmt::print("  store: {:.1f} MB, {:.0f} bytes a robot\n",
             1e-6 * static_cast<double>(std::filesystem::file_size(path)),
             static_cast<double>(std::filesystem::file_size(path)) / robots);
}

double ReportReal(const Experiment& experiment, int jobs,
                  const std::string& path) {
  RunStore store;
  if (const auto failure = store.Create(path, experiment)) {
    fmt::print("{}\n", failure->text);
    return 0;
  }
  Timed timed(store);
  EvolveOptions options;
  options.jobs = jobs;
  options.caches = {&store};
  options.observers = {&timed};
  const double own = CpuSeconds(RUSAGE_SELF);
  const double children = CpuSeconds(RUSAGE_CHILDREN);
  const double wall = WallSeconds();
  const RunResult result = Evolve(experiment, options);
  const double seconds = WallSeconds() - wall;
  const double coordinator = CpuSeconds(RUSAGE_SELF) - own;
  const double all = coordinator + CpuSeconds(RUSAGE_CHILDREN) - children;
  const double rate = static_cast<double>(result.evaluations) / seconds;
  fmt::print(
      "{} workers: {:.2f} robots/s, {:.0f} x real time, coordinator {:.2f} % "
      "of {:.1f} s CPU, of it the store {:.2f} %\n",
      jobs, rate, result.counts_of_work.simulated_seconds / seconds,
      100 * coordinator / all, all, 100 * timed.seconds / all);
  return rate;
}

int Main(bool is_smoke) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() /
      fmt::format("plsc_evolve_bench_{}", getpid());
  std::filesystem::create_directory(folder);
  Experiment paper;
  if (is_smoke) paper.generations = 3;
  ReportStubbed(paper, folder / "stubbed.sqlite");
  Experiment small;
  small.population = is_smoke ? 4 : 60;
  small.offspring = small.population;
  small.generations = is_smoke ? 1 : 4;
  if (is_smoke)
    for (Season& season : small.scenario.seasons) season.duration = 1;
  const double one = ReportReal(small, 1, folder / "one.sqlite");
  const double two = ReportReal(small, 2, folder / "two.sqlite");
  fmt::print("efficiency of 2 workers: {:.3f}\n", two / (2 * one));
  std::filesystem::remove_all(folder);
  return 0;
}

}  // namespace
}  // namespace plsc

int main(int argc, char** argv) {
  return plsc::Main(argc > 1 && std::strcmp(argv[1], "--smoke") == 0);
}
