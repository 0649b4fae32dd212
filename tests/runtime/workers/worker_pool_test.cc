#include "runtime/workers/worker_pool.h"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <cerrno>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/process_end.h"
#include "tests/runtime/workers/worker_helpers.h"
#include "tests/sanitizer.h"

namespace plsc {

using test::Collect;
using test::IsAlive;
using test::kPatience;
using test::SharedCounter;
using test::WaitForEver;

namespace {

pid_t PidFrom(const std::string& text) {
  return static_cast<pid_t>(std::stoi(text));
}

/// Past the pool, to a worker's socket, which is its only descriptor besides
/// the standard streams.
void SendGarbage() {
  const std::string garbage(100, '\xff');
  if (send(3, garbage.data(), garbage.size(), 0) < 0) _exit(1);
}

}  // namespace

TEST_CASE("Every request is answered, by any number of workers", "[workers]") {
  for (const int workers : {1, 2, 3}) {
    CAPTURE(workers);
    WorkerPool pool(workers,
                    [](const std::string& text) { return "<" + text + ">"; });
    CHECK(pool.workers() == workers);
    for (int i = 0; i < 50; ++i) pool.Submit(i, std::to_string(i));
    CHECK(pool.outstanding() == 50);
    CHECK(pool.busy() == workers);
    const auto answers = Collect(pool);
    REQUIRE(answers.size() == 50);
    for (const auto& [ticket, answer] : answers)
      CHECK(answer == "<" + std::to_string(ticket) + ">");
    CHECK(pool.outstanding() == 0);
  }
}

TEST_CASE("Texts may be empty, or larger than a socket's buffer", "[workers]") {
  WorkerPool pool(2, [](const std::string& text) { return text + text; });
  const std::string large(2'000'000, 'x');
  pool.Submit(1, "");
  for (int i = 2; i < 6; ++i) pool.Submit(i, large);
  const auto answers = Collect(pool);
  REQUIRE(answers.size() == 5);
  CHECK(answers.at(1).empty());
  for (int i = 2; i < 6; ++i) CHECK((answers.at(i) == large + large));
}

TEST_CASE("Texts of 10 MB go both ways at once", "[workers][slow]") {
  WorkerPool pool(2, [](const std::string& text) { return text; });
  const std::string large(10'000'000, 'x');
  for (int i = 0; i < 3; ++i) pool.Submit(i, large);
  const auto answers = Collect(pool);
  REQUIRE(answers.size() == 3);
  for (int i = 0; i < 3; ++i) CHECK((answers.at(i) == large));
}

TEST_CASE("A worker that dies is replaced, and its work done again",
          "[workers]") {
  SharedCounter deaths;
  WorkerPool pool(2, [&](const std::string& text) {
    // Only the first worker that gets it dies of it.
    if (text == "7" && deaths.Increment() == 1) raise(SIGKILL);
    return text;
  });
  for (int i = 0; i < 20; ++i) pool.Submit(i, std::to_string(i));
  const auto answers = Collect(pool);
  REQUIRE(answers.size() == 20);
  CHECK(answers.at(7) == "7");
  CHECK(deaths.value() == 2);
  CHECK(pool.workers() == 2);
}

TEST_CASE("What kills two workers is reported and not tried again",
          "[workers]") {
  struct Row {
    const char* why;
    Work work;
    const char* death;
  };
  const std::vector<Row> rows = {{"a crash",
                                  [](const std::string& text) {
                                    if (text == "7") raise(SIGKILL);
                                    return text;
                                  },
                                  "signal 9"},
                                 {"an exception",
                                  [](const std::string& text) {
                                    if (text == "7")
                                      throw std::runtime_error("broken");
                                    return text;
                                  },
                                  "exit status 2"},
                                 {"an exit",
                                  [](const std::string& text) {
                                    if (text == "7") _exit(42);
                                    return text;
                                  },
                                  "exit status 42"},
                                 {"an abort",
                                  [](const std::string& text) {
                                    if (text == "7") abort();
                                    return text;
                                  },
                                  "signal 6"},
                                 {"an answer that is no frame",
                                  [](const std::string& text) {
                                    if (text == "7") SendGarbage();
                                    return text;
                                  },
                                  "an answer that is none"}};
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      WorkerPool pool(2, row.work);
      for (int i = 0; i < 20; ++i) pool.Submit(i, std::to_string(i));
      int deaths = 0;
      int answers = 0;
      while (pool.outstanding() > 0)
        for (const Reply& reply : pool.Wait(kPatience)) {
          if (reply.answer) {
            ++answers;
            continue;
          }
          ++deaths;
          CHECK(reply.ticket == 7);
          CHECK(reply.death == row.death);
        }
      CHECK(deaths == 1);
      CHECK(answers == 19);
      CHECK(pool.workers() == 2);
    }
  }
}

TEST_CASE("Another descriptor that can be read hides no answer", "[workers]") {
  std::array<int, 2> ends{};
  REQUIRE(pipe(ends.data()) == 0);
  REQUIRE(write(ends[1], "x", 1) == 1);
  WorkerPool pool(2, [](const std::string& text) {
    if (text == "never") pause();
    return "<" + text + ">";
  });
  pool.WakeOn(ends[0]);
  pool.Submit(0, "never");
  CHECK(pool.Wait(kPatience).empty());  // comes back for the byte
  CHECK(pool.outstanding() == 1);
  for (int i = 1; i < 20; ++i) pool.Submit(i, std::to_string(i));
  std::map<int, std::string> answers;
  while (answers.size() < 19)
    for (const Reply& reply : pool.Wait(kPatience))
      answers[reply.ticket] = *reply.answer;
  for (const auto& [ticket, answer] : answers)
    CHECK(answer == "<" + std::to_string(ticket) + ">");
  close(ends[0]);
  close(ends[1]);
}

TEST_CASE("Requests that nobody has begun can be cancelled", "[workers]") {
  WorkerPool pool(2, [](const std::string& text) { return text; });
  for (int i = 0; i < 50; ++i) pool.Submit(i, std::to_string(i));
  pool.CancelWaiting();
  CHECK(pool.outstanding() == 2);
  const auto answers = Collect(pool);
  CHECK(answers == std::map<int, std::string>{{0, "0"}, {1, "1"}});
  pool.Submit(99, "again");
  CHECK(Collect(pool).at(99) == "again");
}

TEST_CASE("A pool leaves no process behind", "[workers]") {
  pid_t worker = 0;
  {
    WorkerPool pool(
        1, [](const std::string&) { return std::to_string(getpid()); });
    pool.Submit(0, "");
    worker = PidFrom(Collect(pool).at(0));
    CHECK(IsAlive(worker));
    pool.Submit(1, "");  // it is busy when the pool ends
  }
  // Reaped: not even a zombie, which kill would still find.
  CHECK_FALSE(IsAlive(worker));
  CHECK(waitpid(worker, nullptr, WNOHANG) == -1);
  CHECK(errno == ECHILD);
}

TEST_CASE("Workers die with a parent that is killed", "[workers]") {
  // Orphans become ours, so that we can wait for their end.
  REQUIRE(prctl(PR_SET_CHILD_SUBREAPER, 1) == 0);
  int ends[2];
  REQUIRE(pipe(ends) == 0);
  const pid_t parent = fork();
  if (parent == 0) {
    WorkerPool pool(1, [](const std::string& text) {
      // What has begun would last longer than the test.
      if (text == "for ever") WaitForEver();
      return std::to_string(getpid());
    });
    pool.Submit(0, "");
    const std::string pid = Collect(pool).at(0);
    pool.Submit(1, "for ever");
    if (write(ends[1], pid.data(), pid.size()) < 0) _exit(1);
    WaitForEver();
  }
  char buffer[32] = {};
  REQUIRE(read(ends[0], buffer, sizeof(buffer) - 1) > 0);
  const pid_t worker = PidFrom(buffer);
  CHECK(IsAlive(worker));
  kill(parent, SIGKILL);
  CHECK(waitpid(parent, nullptr, 0) == parent);
  constexpr int kLongEnough = 20'000;  // ms
  REQUIRE(test::EndsWithin(worker, kLongEnough));
  CHECK(waitpid(worker, nullptr, 0) == worker);
  close(ends[0]);
  close(ends[1]);
  prctl(PR_SET_CHILD_SUBREAPER, 0);
}

TEST_CASE("A worker that dies while it gets its request is replaced",
          "[workers]") {
  // More than a socket holds, so that the rest is unsent when it dies.
  const std::string large(5'000'000, 'x');
  WorkerPool pool(1, [](const std::string& text) {
    return text.size() == 1 ? std::to_string(getpid()) : "large";
  });
  pool.Submit(0, "p");
  const pid_t worker = PidFrom(Collect(pool).at(0));
  // It cannot read when it is stopped.
  kill(worker, SIGSTOP);
  pool.Submit(1, large);
  pool.Submit(2, "p");
  CHECK(pool.busy() == 1);
  kill(worker, SIGKILL);
  const auto answers = Collect(pool);
  REQUIRE(answers.size() == 2);
  CHECK(answers.at(1) == "large");
  CHECK(PidFrom(answers.at(2)) != worker);
}

TEST_CASE("A worker that dies before it gets a request is replaced",
          "[workers]") {
  WorkerPool pool(1,
                  [](const std::string&) { return std::to_string(getpid()); });
  pool.Submit(0, "");
  const pid_t worker = PidFrom(Collect(pool).at(0));
  kill(worker, SIGKILL);
  pool.Submit(1, "");
  CHECK(PidFrom(Collect(pool).at(1)) != worker);
}

// Its allocator needs more addresses than any limit leaves.
#if !PLSC_HAS_ASAN
TEST_CASE("A worker without memory is a death, not the end", "[workers]") {
  WorkerPool pool(1, [](const std::string& text) {
    if (text == "much") {
      constexpr rlim_t kLimit = 1 << 28;
      const rlimit limit = {kLimit, kLimit};
      setrlimit(RLIMIT_AS, &limit);
      return std::string(2 * kLimit, 'x');
    }
    return text;
  });
  pool.Submit(0, "much");
  pool.Submit(1, "little");
  const auto answers = Collect(pool);
  CHECK((answers.at(0) == "exit status 2"));
  CHECK(answers.at(1) == "little");
}
#endif

TEST_CASE("A pool that can have no workers says why", "[workers]") {
  rlimit before{};
  REQUIRE(getrlimit(RLIMIT_NOFILE, &before) == 0);
  WorkerPool pool(1, [](const std::string& text) {
    raise(SIGKILL);
    return text;
  });
  // Too few to open another socket.
  const rlimit few = {4, before.rlim_max};
  REQUIRE(setrlimit(RLIMIT_NOFILE, &few) == 0);
  pool.Submit(0, "");
  while (!pool.failure()) pool.Wait(kPatience);
  const WorkerPool none(1, [](const std::string& text) { return text; });
  REQUIRE(setrlimit(RLIMIT_NOFILE, &before) == 0);
  CHECK(pool.failure() == "cannot start a worker: Too many open files");
  CHECK(pool.workers() == 0);
  CHECK(none.failure() == pool.failure());
}

TEST_CASE("A worker that speaks without being asked is replaced", "[workers]") {
  SharedCounter collected;
  WorkerPool pool(2, [&](const std::string& text) {
    // Garbage after the answer reaches the pool when nothing is asked.
    if (text == "twice" && fork() == 0) {
      collected.WaitFor(1);
      SendGarbage();
      _exit(0);
    }
    return std::to_string(getpid());
  });
  pool.Submit(0, "twice");
  const pid_t worker = PidFrom(Collect(pool).at(0));
  collected.Increment();
  // The other worker keeps the pool waiting meanwhile.
  while (IsAlive(worker)) {
    pool.Submit(1, "");
    pool.Submit(2, "");
    Collect(pool);
  }
  CHECK(pool.workers() == 2);
}

TEST_CASE("Ctrl-C and the end of a batch job do not reach the workers",
          "[workers]") {
  WorkerPool pool(1, [](const std::string&) {
    raise(SIGINT);
    raise(SIGTERM);
    raise(SIGUSR1);
    return std::string("alive");
  });
  pool.Submit(0, "");
  CHECK(Collect(pool).at(0) == "alive");
}

}  // namespace plsc
