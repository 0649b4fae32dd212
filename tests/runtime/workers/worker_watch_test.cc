#include "runtime/workers/worker_watch.h"

#include <signal.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <vector>

namespace plsc {

TEST_CASE("What counts against a worker is the time that was its own",
          "[worker_watch]") {
  struct Look {
    double waited;
    std::optional<Vitals> vitals;
  };
  struct Row {
    const char* why;
    std::vector<Look> looks;
    double expected;
  };
  const Vitals begin = {5, false};
  const std::vector<Row> rows = {
      {"it computes", {{1, {{6, false}}}, {1, {{7, false}}}}, 2},
      {"it sleeps, or is stopped", {{1, {{5, true}}}, {1, {{5, true}}}}, 2},
      {"it has a third of a core", {{3, {{6, false}}}, {3, {{7, false}}}}, 2},
      {"it has none", {{1, {{5, false}}}, {1, {{5, false}}}}, 0},
      {"it wakes now and then", {{1, {{5.1, true}}}, {1, {{5.2, true}}}}, 2},
      {"it computed while its owner was away", {{0.1, {{8, false}}}}, 3},
      {"it computed longer than its owner waited, and sleeps now",
       {{0.1, {{8, true}}}},
       3},
      {"nothing is known of it", {{1, {}}, {1, {}}}, 2},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      WorkerWatch watch(begin);
      for (const Look& look : row.looks) watch.Add(look.waited, look.vitals);
      CHECK(watch.own_seconds() == Approx(row.expected));
    }
  }
}

TEST_CASE("Vitals of a process are the system's", "[worker_watch]") {
  // Of ourselves: we run, and have computed what the clock says.
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  const auto ours = ReadVitals(getpid());
  REQUIRE(ours);
  CHECK_FALSE(ours->is_idle);
  CHECK(ours->cpu >= static_cast<double>(time.tv_sec) - 1);

  const pid_t child = fork();
  if (child == 0)
    while (true) pause();
  // Sooner or later it is asleep; and it is no better when it is stopped.
  std::optional<Vitals> vitals;
  do {
    vitals = ReadVitals(child);
    REQUIRE(vitals);
  } while (!vitals->is_idle);
  kill(child, SIGSTOP);
  int status = 0;
  REQUIRE(waitpid(child, &status, WUNTRACED) == child);
  CHECK(ReadVitals(child)->is_idle);
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  CHECK_FALSE(ReadVitals(child));
}

}  // namespace plsc
