#include <sched.h>
#include <signal.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "runtime/workers/worker_pool.h"
#include "tests/runtime/workers/worker_helpers.h"

namespace plsc {

using test::Collect;
using test::SharedCounter;
using test::WaitForEver;

namespace {

double CpuSeconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) +
         1e-9 * static_cast<double>(time.tv_nsec);
}

void Spin(double seconds) {
  const double end = CpuSeconds() + seconds;
  while (CpuSeconds() < end) {
  }
}

std::string HangAtSeven(const std::string& text, void (*hang)()) {
  if (text == "7") hang();
  return text;
}

void SpinForEver() {
  while (true) Spin(600);
}

void DozeForEver() {
  while (true) usleep(2000);
}

void StopForEver() {
  while (true) raise(SIGSTOP);
}

}  // namespace

TEST_CASE("What hangs two workers is reported and not tried again",
          "[workers]") {
  struct Row {
    const char* why;
    void (*hang)();
  };
  const std::vector<Row> rows = {{"it sleeps", WaitForEver},
                                 {"it computes", SpinForEver},
                                 {"it wakes to sleep again", DozeForEver},
                                 {"it is stopped", StopForEver}};
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      SharedCounter begun;
      WorkerPool pool({2, 0.25}, [&](const std::string& text) {
        if (text == "7") begun.Increment();
        return HangAtSeven(text, row.hang);
      });
      for (int i = 0; i < 20; ++i) pool.Submit(i, std::to_string(i));
      const auto answers = Collect(pool);
      REQUIRE(answers.size() == 20);
      for (const auto& [ticket, answer] : answers)
        CHECK(answer ==
              (ticket == 7 ? "no answer for 0.25 s" : std::to_string(ticket)));
      CHECK(begun.value() == 2);
      CHECK(pool.workers() == 2);
    }
  }
}

TEST_CASE("A worker that hung once is forgiven", "[workers]") {
  SharedCounter begun;
  WorkerPool pool({1, 0.25}, [&](const std::string& text) {
    if (begun.Increment() == 1) WaitForEver();
    return text;
  });
  pool.Submit(1, "one");
  CHECK(Collect(pool).at(1) == "one");
  CHECK(begun.value() == 2);
}

TEST_CASE("A worker that does not take its request hangs", "[workers]") {
  WorkerPool pool({1, 0.25}, [](const std::string& text) {
    // Whoever gets the large one next does not even read it.
    if (text == "deaf") {
      const std::string frame = Frame("heard");
      if (write(3, frame.data(), frame.size()) < 0) _exit(1);
      WaitForEver();
    }
    return text.substr(0, 1);
  });
  pool.Submit(0, "deaf");
  CHECK(Collect(pool).at(0) == "heard");
  pool.Submit(1, std::string(10'000'000, 'x'));
  CHECK(Collect(pool).at(1) == "x");
}

TEST_CASE("Without a limit nobody hangs", "[workers]") {
  SharedCounter begun;
  SharedCounter looks;
  constexpr int kLooks = 50;
  WorkerPool pool(1, [&](const std::string& text) {
    begun.Increment();
    looks.WaitFor(kLooks);
    return text;
  });
  pool.Submit(1, "one");
  begun.WaitFor(1);
  for (int i = 0; i < kLooks; ++i) {
    CHECK(pool.Wait(1).empty());
    looks.Increment();
  }
  CHECK(Collect(pool).at(1) == "one");
  CHECK(begun.value() == 1);
}

// Ctrl-Z, `scancel --signal=STOP`, a laptop's lid.
TEST_CASE("Whose process group was stopped for long does not hang",
          "[workers][slow]") {
  SharedCounter begun;
  SharedCounter deaths;
  deaths.Set(-1);
  const pid_t group = fork();
  if (group == 0) {
    setpgid(0, 0);
    // A limit that a busy machine does not reach by itself.
    WorkerPool pool({2, 1.5}, [&](const std::string& text) {
      begun.Increment();
      if (text == "0")
        Spin(0.1);
      else
        usleep(100'000);  // what the stop does not prolong
      return text;
    });
    pool.Submit(0, "0");
    pool.Submit(1, "1");
    int dead = 0;
    while (pool.outstanding() > 0)
      for (const Reply& reply : pool.Wait(test::kPatience))
        dead += !reply.answer;
    deaths.Set(dead);
    _exit(0);
  }
  begun.WaitFor(2);
  kill(-group, SIGSTOP);
  // Twice the limit: what is tried is that time passes.
  sleep(3);
  kill(-group, SIGCONT);
  int status = 0;
  REQUIRE(waitpid(group, &status, 0) == group);
  CHECK(status == 0);
  CHECK(deaths.value() == 0);
  CHECK(begun.value() == 2);
}

// Four workers on one core, each of which needs nearly the limit.
TEST_CASE("Who waits for a core does not hang", "[workers][slow]") {
  cpu_set_t before;
  REQUIRE(sched_getaffinity(0, sizeof before, &before) == 0);
  cpu_set_t one;
  CPU_ZERO(&one);
  for (int core = 0; CPU_COUNT(&one) == 0; ++core)
    if (CPU_ISSET(core, &before)) CPU_SET(core, &one);
  REQUIRE(sched_setaffinity(0, sizeof one, &one) == 0);
  SharedCounter begun;
  {
    WorkerPool pool({4, 0.4}, [&](const std::string& text) {
      begun.Increment();
      Spin(0.28);
      return text;
    });
    for (int i = 0; i < 4; ++i) pool.Submit(i, std::to_string(i));
    for (const auto& [ticket, answer] : Collect(pool))
      CHECK(answer == std::to_string(ticket));
  }
  CHECK(begun.value() == 4);
  REQUIRE(sched_setaffinity(0, sizeof before, &before) == 0);
}

}  // namespace plsc
