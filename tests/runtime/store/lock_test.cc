#include "runtime/store/lock.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
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
  const std::string who = "process " + std::to_string(holder.pid()) + " on ";
  RunLock lock;
  const auto failure = lock.Take(run);
  REQUIRE(failure);
  CHECK(failure->find("'" + run + "' is in use by " + who) == 0);
  CHECK(WhoWorksOn(run).value_or("").find(who) == 0);
  RunStore store;
  CHECK(store.Open(run).value_or("").find("is in use by " + who) !=
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
  CHECK(scratch.Files() == std::vector<std::string>{"run.lock"});
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
  REQUIRE(test::Show(recorder, store, 0, 1) == "");
  const std::vector<std::string> files = {"run", "run-shm", "run-wal",
                                          "run.lock"};
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

TEST_CASE("A lock that cannot be made says why", "[lock]") {
  const test::Scratch scratch;
  RunLock lock;
  CHECK(lock.Take(scratch / "none/run") == "cannot create '" +
                                               (scratch / "none/run.lock") +
                                               "': No such file or directory");
}

}  // namespace plsc
