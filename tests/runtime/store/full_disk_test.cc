// A disk that fills up in the middle of a run: by a limit on the size of files
// in a process of its own, and by a file system that is small, where the tests
// may mount one.

#include <signal.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <string>

#include "runtime/store/result_dump.h"
#include "tests/runtime/store/stored_run.h"

namespace plsc {

namespace {

using test::Recorder;
using test::Scratch;

const Recorder& SmallRun() {
  static const Recorder run = test::RecordRun(test::StoredExperiment());
  return run;
}

/// Reports to a store what it does not have yet.
std::string GoOn(RunStore& store) {
  auto saved = store.Load();
  if (!saved) return saved.error().text;
  const Recorder& run = SmallRun();
  for (auto g = static_cast<std::size_t>(saved->generations);
       g < run.births.size(); ++g) {
    std::vector<Individual> born;
    for (const int id : run.births[g])
      born.push_back(run.individuals[static_cast<std::size_t>(id - 1)]);
    if (auto failure = store.OnBirths(born, {})) return failure->text;
    for (const Individual& one : born) {
      if (saved->evaluated.contains(one.id)) continue;
      if (auto failure = store.OnEvaluated(
              one, run.evidence[static_cast<std::size_t>(one.id - 1)]))
        return failure->text;
    }
    if (auto failure = store.OnGeneration(run.generations[g]))
      return failure->text;
  }
  return store.Close().value_or("").text;
}

void CheckGoesOn(const std::string& path) {
  RunStore store;
  REQUIRE(store.Open(path) == std::nullopt);
  REQUIRE(GoOn(store) == "");
  const Scratch scratch;
  test::WriteRun(scratch / "straight");
  CHECK(*DumpResults(path) == *DumpResults(scratch / "straight"));
}

/// What a process of its own whose files may have so many bytes is told;
/// empty: nothing.
std::string RunWithLimit(const std::string& path, rlim_t limit) {
  const std::string answer = path + ".answer";
  test::WriteBytes(answer, std::string(500, ' '));
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    signal(SIGXFSZ, SIG_IGN);
    const rlimit small = {limit, limit};
    setrlimit(RLIMIT_FSIZE, &small);
    std::string told;
    {
      RunStore store;
      const bool is_new = !std::filesystem::exists(path);
      told = (is_new ? store.Create(path, test::StoredExperiment())
                     : store.Open(path))
                 .value_or("")
                 .text;
      if (told.empty()) told = GoOn(store);
    }
    std::ofstream(answer) << told;
    _exit(0);
  }
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  REQUIRE(WIFEXITED(status));
  const std::string told = test::ReadBytes(answer);
  std::filesystem::remove(answer);
  return told;
}

}  // namespace

TEST_CASE("A full disk ends a run with its reason, and it goes on afterwards",
          "[full_disk]") {
  const Scratch scratch;
  const std::string path = scratch / "run";
  SmallRun();  // before the forks
  int failures = 0;
  // From what does not hold an empty store to what holds half a run.
  for (const rlim_t limit : {10'000u, 60'000u, 200'000u, 300'000u, 400'000u}) {
    CAPTURE(limit);
    const std::string told = RunWithLimit(path, limit);
    CAPTURE(told);
    if (told.empty()) continue;
    ++failures;
    CHECK(told.find(path) != std::string::npos);
    CHECK(told.find("File too large") != std::string::npos);
    if (!std::filesystem::exists(path)) CHECK(scratch.Files().empty());
  }
  CHECK(failures >= 3);
  REQUIRE(std::filesystem::exists(path));
  CheckGoesOn(path);
}

TEST_CASE("A full file system ends a run with its reason", "[full_disk]") {
  const Scratch scratch;
  const std::string folder = scratch / "small";
  std::filesystem::create_directory(folder);
  SmallRun();
  // Only root may, and not in every container.
  if (mount("none", folder.c_str(), "tmpfs", 0, "size=300k") != 0) {
    WARN("no file system could be mounted; nothing was tested");
    return;
  }
  std::string told;
  {
    RunStore store;
    told = store.Create(folder + "/run", test::StoredExperiment())
               .value_or("")
               .text;
    if (told.empty()) told = GoOn(store);
  }
  CAPTURE(told);
  CHECK(told.find("No space left on device") != std::string::npos);
  // Moved to where there is room, journal included, it goes on.
  for (const char* end : {"", "-wal"})
    if (std::filesystem::exists(folder + "/run" + end))
      std::filesystem::copy_file(folder + "/run" + end,
                                 (scratch / "run") + end);
  umount(folder.c_str());
  CheckGoesOn(scratch / "run");
}

}  // namespace plsc
