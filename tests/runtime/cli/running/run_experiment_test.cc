#include "runtime/cli/running/run_experiment.h"

#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <sstream>
#include <string>

#include "runtime/store/result_dump.h"
#include "runtime/store/run_store.h"
#include "tests/runtime/cli/tiny_run.h"

namespace plsc {
namespace {

/// Streams that nobody reads but the test.
struct Quiet {
  std::istringstream in;
  std::ostringstream out;
  std::ostringstream err;
  cli::Io io{in, out, err, false, false};
};

Experiment Tiny(int generations) {
  Experiment experiment =
      *ParseExperiment(Source("tiny", test::kTinyExperiment));
  experiment.generations = generations;
  return experiment;
}

cli::RunRequest RequestFor(const std::string& path, int generations) {
  cli::RunRequest request;
  request.path = path;
  request.experiment = Tiny(generations);
  request.jobs = 2;
  return request;
}

TEST_CASE("a request makes a run, and tells what it took", "[run_experiment]") {
  const test::TemporaryFolder folder;
  Quiet streams;
  const cli::RunOutcome outcome =
      cli::ExecuteRun(RequestFor(folder / "run.sqlite", 3), streams.io);
  CHECK(outcome.exit == cli::Exit::kFine);
  CHECK(outcome.result.generations == 3);
  CHECK(outcome.effort.evaluations == 18);
  CHECK(outcome.effort.workers == 2);
  CHECK(outcome.effort.seconds > 0);
  CHECK(outcome.effort.counts.simulations + outcome.effort.counts.looked_up ==
        36);
  CHECK(streams.err.str().find("generation 3/3") != std::string::npos);
}

TEST_CASE("a run that is locked is told from one that fails",
          "[run_experiment]") {
  const test::TemporaryFolder folder;
  const std::string path = folder / "run.sqlite";
  Quiet streams;
  REQUIRE(cli::ExecuteRun(RequestFor(path, 1), streams.io).exit ==
          cli::Exit::kFine);
  // Locks are a process's, so another one must hold it.
  int ready[2];
  int done[2];
  REQUIRE(pipe(ready) == 0);
  REQUIRE(pipe(done) == 0);
  const pid_t child = fork();
  if (child == 0) {
    RunStore store;
    char byte = store.Open(path) ? 'n' : 'y';
    if (write(ready[1], &byte, 1) != 1 || read(done[0], &byte, 1) < 0) _exit(1);
    _exit(0);
  }
  char byte = 0;
  REQUIRE(read(ready[0], &byte, 1) == 1);
  REQUIRE(byte == 'y');
  cli::RunRequest request = RequestFor(path, 1);
  request.may_resume = true;
  const cli::RunOutcome locked = cli::ExecuteRun(request, streams.io);
  CHECK(locked.exit == cli::Exit::kBadInput);
  CHECK(locked.is_locked);
  CHECK(streams.err.str().find(std::to_string(child)) != std::string::npos);
  REQUIRE(write(done[1], &byte, 1) == 1);
  waitpid(child, nullptr, 0);
  CHECK(cli::ExecuteRun(request, streams.io).exit == cli::Exit::kFine);
  request.experiment->seed = 99;
  const cli::RunOutcome other = cli::ExecuteRun(request, streams.io);
  CHECK(other.exit == cli::Exit::kBadInput);
  CHECK_FALSE(other.is_locked);
  for (const int end : {ready[0], ready[1], done[0], done[1]}) close(end);
}

TEST_CASE("a run of another program is gone on with only if that is wanted",
          "[run_experiment]") {
  const test::TemporaryFolder folder;
  const std::string path = folder / "run.sqlite";
  {
    RunStore store;
    Versions versions = ThisProgram();
    versions.plsc = "0.0.1";
    REQUIRE_FALSE(store.Create(path, Tiny(1), versions));
    REQUIRE_FALSE(store.Close());
  }
  Quiet streams;
  cli::RunRequest request;
  request.path = path;
  CHECK(cli::ExecuteRun(request, streams.io).exit == cli::Exit::kBadInput);
  CHECK(streams.err.str().find("0.0.1") != std::string::npos);
  CHECK(streams.err.str().find("--allow-other-version") != std::string::npos);
  request.allow_other_version = true;
  CHECK(cli::ExecuteRun(request, streams.io).exit == cli::Exit::kFine);
}

}  // namespace
}  // namespace plsc
