// What `plsc report` of the paper's whole study takes: 80 runs of 20,000 robots
// each, 1.6 million. Reports; asserts nothing.
//
//   report_bench [--smoke] [--folder FOLDER] [--distinct N] [--of STUDY]
//
// Robots really develop, breed and are stored; only their lives are stubbed.
// Of the 20 runs of each experiment N (default 2) are evolved and the others
// copied from these under their own names and seeds, because to make all of
// them would take half an hour: for the reader, a file is a file. A folder that
// is named and has the study already is used as it is and kept.
//
// With --of the runs are those that are done in the folder STUDY, which stays
// as it is, with their relived lives and claims, and again as many copies as
// its study lacks runs.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "runtime/cli/run.h"
#include "runtime/develop/phenotype_json.h"
#include "runtime/evolve/evolve.h"
#include "runtime/life/simulated.h"
#include "runtime/relive/relived_file.h"
#include "runtime/store/checksum.h"
#include "runtime/store/database.h"
#include "runtime/store/run_store.h"
#include "runtime/study/run_report.h"
#include "runtime/study/study_folder.h"

namespace plsc {
namespace {

namespace fs = std::filesystem;

// Few speeds, the best of which many robots have: then populations drift, and
// do not end as copies of one robot.
constexpr std::uint64_t kLevels = 4;

/// As if simulated: numbers that follow from the phenotype.
Simulated Stub(const Phenotype& robot, const Season& season,
               const Disturbance& /*disturbance*/) {
  Simulated stub;
  const Key key = KeyOf(BodyJson(robot.body) + BrainJson(robot) + season.name);
  stub.behaviour.is_valid = true;
  stub.behaviour.displacement_velocity_hill =
      1e-2 * static_cast<double>(key.low % kLevels);
  stub.behaviour.velocity = stub.behaviour.displacement_velocity_hill;
  stub.behaviour.displacement_velocity = stub.behaviour.velocity;
  stub.behaviour.head_balance = std::ldexp(static_cast<double>(key.high), -64);
  stub.state_hash = key.low;
  stub.steps = 10000;
  return stub;
}

/// The paper's study (examples/paper_study.yaml), or a thousandth of it.
Study MakeStudy(bool is_smoke) {
  Study study;
  study.name = "paper";
  study.seed = 2020;
  study.repetitions = is_smoke ? 3 : 20;
  Experiment plastic;
  if (is_smoke) {
    plastic.population = 6;
    plastic.offspring = 6;
    plastic.generations = 4;
  }
  Experiment baseline = plastic;
  baseline.genotype.encoding = Encoding::kBaseline;
  Experiment flat = baseline;
  flat.scenario.seasons.resize(1);
  Experiment tilted = baseline;
  tilted.scenario.seasons.erase(tilted.scenario.seasons.begin());
  study.experiments = {{"plastic", plastic},
                       {"baseline", baseline},
                       {"flat", flat},
                       {"tilted", tilted}};
  return study;
}

void Require(const MaybeFailure& failure) {
  if (!failure) return;
  fmt::print("error: {}\n", failure->text);
  std::exit(1);
}

void EvolveInto(const std::string& path, const Experiment& experiment) {
  RunStore store;
  Require(store.Create(path, experiment));
  Require(store.BeginSession({"2026-01-01T00:00:00Z", 2}));
  EvolveOptions options;
  options.simulate = Stub;
  options.caches = {&store};
  options.observers = {&store};
  const RunResult result = Evolve(experiment, options);
  SessionEnd end;
  end.ended = "2026-01-01T01:00:00Z";
  end.how = "finished";
  end.seconds = 3600;
  end.cpu_seconds = 7200;
  end.evaluations = result.evaluations;
  end.simulated = result.counts_of_work.simulations;
  end.looked_up = result.counts_of_work.looked_up;
  Require(store.EndSession(end));
  Require(store.Close());
}

/// The same results under another run's name and seed.
void CopyAs(const std::string& from, const std::string& to,
            const Experiment& experiment) {
  fs::copy_file(from, to);
  Database database;
  Require(database.Open(to, Database::Mode::kWrite));
  Statement(database, "UPDATE run SET name = ?, seed = ?, experiment = ?")
      .With(experiment.name, std::to_string(experiment.seed),
            PrintExperiment(experiment))
      .Run();
  Statement(database, "UPDATE run SET checksum = ?")
      .With(Checksums(database).OfRun())
      .Run();
  Require(database.TakeFailure());
}

/// What a run's robots lived again, as that of the copy.
void CopyRelivedAs(const std::string& from, const std::string& to) {
  if (!fs::exists(RelivedPathOf(from)) || fs::exists(RelivedPathOf(to))) return;
  fs::copy_file(RelivedPathOf(from), RelivedPathOf(to));
  RunStore store;
  Require(store.OpenForReading(to));
  const auto identity = IdentityOf(store);
  Require(identity ? MaybeFailure() : identity.error());
  Database database;
  Require(database.Open(RelivedPathOf(to), Database::Mode::kWrite));
  Statement(database, "UPDATE relived SET name = ?, seed = ?, run = ?")
      .With(identity->name, identity->seed, identity->checksum)
      .Run();
  Require(database.TakeFailure());
}

/// Runs that are done, by experiment, and all others as copies of these.
void CopyRuns(const std::string& from, const std::string& folder,
              const Study& study) {
  Require(PrepareFolder(folder, study));
  for (const auto& file : fs::directory_iterator(from))
    if (file.path().filename().string().starts_with("claims"))
      fs::copy_file(file.path(), fs::path(folder) / file.path().filename(),
                    fs::copy_options::skip_existing);
  std::map<std::size_t, std::vector<std::string>> there;
  for (const StudyRun& run : RunsOf(study)) {
    if (ReportOn(from, study, run).state == RunState::kDone)
      there[run.experiment].push_back(RunPath(from, study, run));
  }
  for (const StudyRun& run : RunsOf(study)) {
    const std::vector<std::string>& sources = there[run.experiment];
    const std::string path = RunPath(folder, study, run);
    if (sources.empty() || fs::exists(path)) continue;
    const std::string& source =
        sources[static_cast<std::size_t>(run.repetition - 1) % sources.size()];
    CopyAs(source, path, ExperimentOf(study, run));
    CopyRelivedAs(source, path);
  }
}

void MakeRuns(const std::string& folder, const Study& study, int distinct) {
  Require(PrepareFolder(folder, study));
  for (const StudyRun& run : RunsOf(study)) {
    const std::string path = RunPath(folder, study, run);
    if (fs::exists(path)) continue;
    const Experiment experiment = ExperimentOf(study, run);
    if (run.repetition <= distinct) {
      EvolveInto(path, experiment);
      fmt::print("{}: {:.1f} MB\n", RunName(study, run),
                 1e-6 * static_cast<double>(fs::file_size(path)));
    } else {
      const StudyRun source{run.experiment, 1 + run.repetition % distinct};
      CopyAs(RunPath(folder, study, source), path, experiment);
    }
  }
}

/// The command in a process of its own, so that its memory can be told.
void Measure(const std::vector<std::string>& words) {
  const auto begin = std::chrono::steady_clock::now();
  std::fflush(stdout);  // or the child would print it, too
  const pid_t child = fork();
  if (child == 0) {
    std::istringstream in;
    std::ostringstream out;
    cli::Io io{in, out, std::cerr};
    const cli::Exit exit = cli::Main(words, io);
    _exit(static_cast<int>(exit));
  }
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin)
          .count();
  const auto cpu = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) +
           1e-6 * static_cast<double>(t.tv_usec);
  };
  fmt::print(
      "plsc {}: {:.2f} s by the wall, {:.2f} s CPU, {:.0f} MiB at most, exit "
      "status {}\n",
      fmt::join(words, " "), seconds, cpu(usage.ru_utime) + cpu(usage.ru_stime),
      static_cast<double>(usage.ru_maxrss) / 1024, WEXITSTATUS(status));
}

void MeasureAll(const std::string& folder, const Study& study) {
  const std::string page = folder + "/report.html";
  for (const char* measures : {"paper", "all"}) {
    Measure({"report", folder, "-o", page, "--quiet", "--measures", measures});
    if (fs::exists(page))
      fmt::print("  its page has {:.2f} MB\n",
                 1e-6 * static_cast<double>(fs::file_size(page)));
  }
  Measure({"report", folder, "--format", "files", "-o", folder + "/figures"});
  const std::string digest = folder + "/digest.json";
  Measure(
      {"study", "digest", folder, "-o", digest, "--every", "20", "--quiet"});
  Measure({"report", digest, "-o", page, "--quiet"});
  Measure({"study", "status", folder});
  Measure({"study", "list", folder + "/study.yaml"});
  const std::string run = RunPath(folder, study, RunsOf(study).front());
  Measure({"show", run});
  Measure({"export", run, "--jsonl", "-o", folder + "/run.jsonl"});
}

struct Options {
  bool is_smoke = false;
  std::string folder;
  std::string of;  ///< a study's folder; empty: none
  int distinct = 2;
};

Options ParseOptions(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--smoke") options.is_smoke = true;
    if (i + 1 == argc) continue;
    if (word == "--folder") options.folder = argv[i + 1];
    if (word == "--of") options.of = argv[i + 1];
    if (word == "--distinct") options.distinct = std::max(1, atoi(argv[i + 1]));
  }
  return options;
}

int Main(const Options& options) {
  const fs::path own =
      fs::temp_directory_path() / fmt::format("plsc_report_bench_{}", getpid());
  const std::string folder =
      options.folder.empty() ? own.string() : options.folder;
  Study study = MakeStudy(options.is_smoke);
  if (options.of.empty()) {
    MakeRuns(folder, study, options.distinct);
  } else {
    const auto other = StudyIn(options.of);
    Require(other ? MaybeFailure() : other.error());
    study = *other;
    CopyRuns(options.of, folder, study);
  }
  MeasureAll(folder, study);
  if (options.folder.empty()) fs::remove_all(own);
  return 0;
}

}  // namespace
}  // namespace plsc

int main(int argc, char** argv) {
  return plsc::Main(plsc::ParseOptions(argc, argv));
}
