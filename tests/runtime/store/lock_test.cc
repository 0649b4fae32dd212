#include "runtime/store/lock.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "tests/runtime/store/stored_run.h"

namespace plsc {

namespace {

/// Another process that holds a run's lock until it is killed.
class Holder {
 public:
  explicit Holder(const std::string& run) {
    std::array<int, 2> ready{};
    REQUIRE(pipe(ready.data()) == 0);
    pid_ = fork();
    REQUIRE(pid_ >= 0);
    if (pid_ == 0) {
      RunLock lock;
      const char answer = lock.Take(run) ? 'n' : 'y';
      if (write(ready[1], &answer, 1) != 1) _exit(1);
      while (true) pause();
    }
    char answer = 0;
    REQUIRE(read(ready[0], &answer, 1) == 1);
    CHECK(answer == 'y');
    close(ready[0]);
    close(ready[1]);
  }
  ~Holder() { Kill(); }
  Holder(const Holder&) = delete;
  Holder& operator=(const Holder&) = delete;
  void Kill() {
    if (pid_ == 0) return;
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
    pid_ = 0;
  }
  pid_t pid() const { return pid_; }

 private:
  pid_t pid_ = 0;
};

}  // namespace

TEST_CASE("The second process on a run is refused by name", "[lock]") {
  const test::Scratch scratch;
  const std::string run = scratch / "run";
  test::WriteRun(run, 1);
  Holder holder(run);
  const std::string who = "process " + std::to_string(holder.pid());
  RunLock lock;
  const auto failure = lock.Take(run);
  REQUIRE(failure);
  CHECK(failure->text.find("'" + run + "' is in use by " + who) == 0);
  CHECK(WhoWorksOn(run).value_or("").find(who) == 0);
  RunStore store;
  CHECK(store.Open(run).value_or("").text.find("is in use by " + who) !=
        std::string::npos);
  // Readers are not.
  CHECK(store.OpenForReading(run) == std::nullopt);
  CHECK(store.Load()->generations == 1);

  // A lock goes with its process, however it ended.
  holder.Kill();
  CHECK_FALSE(WhoWorksOn(run));
  CHECK(lock.Take(run) == std::nullopt);
  lock.Release();
  CHECK(scratch.Files() == std::vector<std::string>{"run"});
  CHECK(store.Open(run) == std::nullopt);
}

TEST_CASE("A child of who holds a run's lock neither has it nor drops it",
          "[lock]") {
  const test::Scratch scratch;
  const std::string run = scratch / "run";
  test::WriteRun(run, 1);
  RunLock lock;
  REQUIRE(lock.Take(run) == std::nullopt);
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    // As a worker that ends in good order; and it is refused, too.
    RunLock other;
    const bool is_refused = other.Take(run).has_value();
    lock.Release();
    _exit(is_refused ? 0 : 1);
  }
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  CHECK(WEXITSTATUS(status) == 0);
  CHECK(scratch.Files() == std::vector<std::string>{"run"});
  const pid_t second = fork();
  REQUIRE(second >= 0);
  if (second == 0) {
    RunLock other;
    _exit(other.Take(run) ? 0 : 1);
  }
  REQUIRE(waitpid(second, &status, 0) == second);
  CHECK(WEXITSTATUS(status) == 0);
}

TEST_CASE("A child that ends in good order leaves its parent's run alone",
          "[lock]") {
  const test::Scratch scratch;
  const std::string run = scratch / "run";
  const test::Recorder recorder = test::RecordRun(test::StoredExperiment());
  RunStore store;
  REQUIRE(store.Create(run, test::StoredExperiment()) == std::nullopt);
  REQUIRE(test::Report(recorder, store, 0, 1) == "");
  const std::vector<std::string> files = {"run", "run-shm", "run-wal"};
  CHECK(scratch.Files() == files);
  const std::string bytes = test::ReadBytes(run);
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    const bool is_quiet = !store.Close();  // as destructors would
    _exit(is_quiet ? 0 : 1);
  }
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  CHECK(WEXITSTATUS(status) == 0);
  CHECK(scratch.Files() == files);
  CHECK(test::ReadBytes(run) == bytes);
  CHECK(store.Load()->generations == 1);
  CHECK(store.Close() == std::nullopt);
  CHECK(scratch.Files() == std::vector<std::string>{"run"});
}

TEST_CASE("A run is locked under all its names", "[lock]") {
  const test::Scratch scratch;
  const std::string run = scratch / "run";
  test::WriteRun(run, 1);
  std::filesystem::create_symlink("run", scratch / "soft");
  std::filesystem::create_hard_link(run, scratch / "hard");
  const std::string bytes = test::ReadBytes(run);
  Holder holder(run);
  const std::string who = "process " + std::to_string(holder.pid());
  for (const char* name : {"soft", "hard"}) {
    CAPTURE(name);
    RunLock lock;
    CHECK(
        lock.Take(scratch / name).value_or("").text.find("in use by " + who) !=
        std::string::npos);
    CHECK(WhoWorksOn(scratch / name) == who);
    RunStore store;
    CHECK(store.Open(scratch / name));
  }
  holder.Kill();
  RunStore store;
  // Each of two names would have its own journal.
  CHECK(store.Open(scratch / "hard").value_or("").text.find("2 names") !=
        std::string::npos);
  CHECK(store.Open(run).value_or("").text.find("2 names") != std::string::npos);
  CHECK(test::ReadBytes(run) == bytes);
  std::filesystem::remove(scratch / "hard");
  // A symbolic link is the same file, with the same journal.
  REQUIRE(store.Open(scratch / "soft") == std::nullopt);
  CHECK(scratch.Files() ==
        std::vector<std::string>{"run", "run-shm", "run-wal", "soft"});
  CHECK(store.Close() == std::nullopt);
}

TEST_CASE("Whoever asks for the lock leaves SQLite its own", "[lock]") {
  const test::Scratch scratch;
  const std::string run = scratch / "run";
  const test::Recorder recorder = test::RecordRun(test::StoredExperiment());
  RunStore store;
  REQUIRE(store.Create(run, test::StoredExperiment()) == std::nullopt);
  REQUIRE(store.BeginSession({"2026-03-01T12:00:00Z", 1}) == std::nullopt);
  REQUIRE(test::Report(recorder, store, 0, 1) == "");
  // A second one in this process, and questions.
  RunStore second;
  CHECK(second.Open(run).value_or("").text.find(
            "in use by process " + std::to_string(getpid()) + " on ") !=
        std::string::npos);
  CHECK(WhoWorksOn(run));
  // The last who closes a database deletes its journal; another process that
  // found our locks gone would take itself for that.
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    const std::string command = "sqlite3 '" + run +
                                "' 'SELECT count(*) FROM individual' "
                                ">/dev/null 2>&1";
    _exit(std::system(command.c_str()) == 0 ? 0 : 1);
  }
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  if (WEXITSTATUS(status) != 0) WARN("no sqlite3 to ask; nothing was tested");
  CHECK(scratch.Files() ==
        std::vector<std::string>{"run", "run-shm", "run-wal"});
  CHECK(store.Load()->generations == 1);
  CHECK(store.Close() == std::nullopt);
  CHECK(scratch.Files() == std::vector<std::string>{"run"});
}

TEST_CASE("What cannot be locked says why", "[lock]") {
  const test::Scratch scratch;
  RunLock lock;
  CHECK(lock.Take(scratch / "none/run") == "cannot open '" +
                                               (scratch / "none/run") +
                                               "': No such file or directory");
}

}  // namespace plsc
