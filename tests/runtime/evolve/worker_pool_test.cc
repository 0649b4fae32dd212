#include "runtime/evolve/worker_pool.h"

#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cerrno>
#include <map>
#include <stdexcept>
#include <string>

namespace plsc {

namespace {

constexpr int kPatience = 100;  // ms

/// Answers by ticket; the empty string for those without.
std::map<int, std::string> Collect(WorkerPool& pool) {
  std::map<int, std::string> answers;
  while (pool.outstanding() > 0 && !pool.failure())
    for (const Reply& reply : pool.Wait(kPatience))
      answers[reply.ticket] = reply.answer.value_or("");
  return answers;
}

/// A number that all processes share, to count what workers did.
class SharedCounter {
 public:
  SharedCounter()
      : count_(
            static_cast<int*>(mmap(nullptr, sizeof(int), PROT_READ | PROT_WRITE,
                                   MAP_SHARED | MAP_ANONYMOUS, -1, 0))) {}
  ~SharedCounter() { munmap(count_, sizeof(int)); }
  SharedCounter(const SharedCounter&) = delete;
  SharedCounter& operator=(const SharedCounter&) = delete;
  int Increment() { return __atomic_add_fetch(count_, 1, __ATOMIC_SEQ_CST); }
  int value() const { return __atomic_load_n(count_, __ATOMIC_SEQ_CST); }

 private:
  int* count_;
};

bool IsAlive(pid_t pid) {
  return kill(pid, 0) == 0;
}

pid_t PidFrom(const std::string& text) {
  return static_cast<pid_t>(std::stoi(text));
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
  const std::string large(5'000'000, 'x');
  pool.Submit(1, "");
  pool.Submit(2, large);
  const auto answers = Collect(pool);
  CHECK(answers.at(1).empty());
  CHECK(answers.at(2) == large + large);
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
                                  "exit status 42"}};
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
  int ends[2];
  REQUIRE(pipe(ends) == 0);
  const pid_t parent = fork();
  if (parent == 0) {
    WorkerPool pool(1, [](const std::string& text) {
      // What has begun would last longer than the test.
      if (text == "sleep") sleep(600);
      return std::to_string(getpid());
    });
    pool.Submit(0, "");
    const std::string pid = Collect(pool).at(0);
    pool.Submit(1, "sleep");
    if (write(ends[1], pid.data(), pid.size()) < 0) _exit(1);
    sleep(600);
    _exit(0);
  }
  char buffer[32] = {};
  REQUIRE(read(ends[0], buffer, sizeof(buffer) - 1) > 0);
  const pid_t worker = PidFrom(buffer);
  CHECK(IsAlive(worker));
  kill(parent, SIGKILL);
  waitpid(parent, nullptr, 0);
  // Somebody else reaps the orphan, which may take a moment; the read end of
  // the pipe closes when it is gone, as it holds the only other copy.
  close(ends[1]);
  pollfd end = {ends[0], POLLIN, 0};
  constexpr int kLongEnough = 10'000;  // ms, on the most loaded machine
  REQUIRE(poll(&end, 1, kLongEnough) == 1);
  CHECK(read(ends[0], buffer, sizeof(buffer)) == 0);
  close(ends[0]);
}

TEST_CASE("Ctrl-C does not reach the workers", "[workers]") {
  WorkerPool pool(1, [](const std::string&) {
    raise(SIGINT);
    return std::string("alive");
  });
  pool.Submit(0, "");
  CHECK(Collect(pool).at(0) == "alive");
}

}  // namespace plsc
