// Run under mpirun by mpi_test.sh: every rank joins, and rank 0 compares what
// the workers of all ranks answer with what they should. Ends with status 0 if
// all is as it should be, 77 where plsc was built without MPI.

#include <fmt/format.h>
#include <signal.h>
#include <time.h>
#include <unistd.h>

#include <cstdlib>
#include <map>
#include <string>

#include "runtime/workers/mpi_session.h"
#include "runtime/workers/worker_pool.h"
#include "tests/runtime/workers/worker_helpers.h"

namespace plsc {
namespace {

using test::Collect;

int failures = 0;

void Expect(bool is_true, const std::string& what) {
  if (is_true) return;
  ++failures;
  fmt::print(stderr, "FAILED: {}\n", what);
}

// In a worker: of the rank that forked it.
bool IsOnRank0() {
  const char* rank = std::getenv("OMPI_COMM_WORLD_RANK");
  return rank != nullptr && std::string(rank) == "0";
}

/// A worker's answer depends on the request and the setup alone; some requests
/// do harm first, and some of these on other ranks only.
Work MakeTestWork(const std::string& setup) {
  return [setup](const std::string& text) -> std::string {
    const bool is_harmed = !text.starts_with("remote ") || !IsOnRank0();
    if (text.ends_with("kill") && is_harmed) raise(SIGKILL);
    if (text.ends_with("segv") && is_harmed) raise(SIGSEGV);
    if (text.ends_with("hang") && is_harmed)
      while (true) pause();
    // Leaves time for the others to get their share of these.
    if (text.starts_with("remote ")) usleep(30'000);
    if (text.ends_with("where")) return IsOnRank0() ? "here" : "there";
    if (text.ends_with("nap")) usleep(30'000);
    return setup + std::string(text.rbegin(), text.rend());
  };
}

constexpr int kJobs = 2;

void TestEqualReplies(MpiSession& session) {
  std::map<int, std::string> requests;
  for (int i = 0; i < 300; ++i) requests[i] = fmt::format("request {}", i);
  // Both ways at once, and far more than MPI sends without being asked.
  for (int i = 300; i < 310; ++i) requests[i] = std::string(2'000'000, 'x');
  requests[310] = "";
  const auto workers = session.MakeWorkers("setup ", 0);
  Expect(workers->workers() == kJobs * session.size(), "workers of all ranks");
  WorkerPool pool(2, MakeTestWork("setup "));
  for (const auto& [ticket, request] : requests) {
    workers->Submit(ticket, request);
    pool.Submit(ticket, request);
  }
  Expect(workers->outstanding() == 311, "all are outstanding");
  Expect(workers->busy() == workers->workers(), "all have something to do");
  Expect(Collect(*workers) == Collect(pool), "replies as of a forked pool");
  Expect(workers->busy() == 0, "nobody is busy any more");
}

void TestPlaces(MpiSession& session) {
  const auto workers = session.MakeWorkers("", 0);
  for (int i = 0; i < 100; ++i) workers->Submit(i, "nap where");
  std::map<std::string, int> places;
  for (const auto& [ticket, place] : Collect(*workers)) ++places[place];
  Expect(places["here"] > 0 && places["there"] > 0, "all ranks do something");
}

void TestAnotherSetup(MpiSession& session) {
  for (const std::string setup : {"one ", "two ", ""}) {
    const auto workers = session.MakeWorkers(setup, 0);
    for (int i = 0; i < 50; ++i) workers->Submit(i, "x");
    for (const auto& [ticket, answer] : Collect(*workers))
      Expect(answer == setup + "x", "the setup is the latest");
  }
}

void TestDeaths(MpiSession& session) {
  const auto workers = session.MakeWorkers("", 0.3);
  struct Row {
    const char* harm;
    const char* death;
  };
  for (const Row& row : {Row{"kill", "signal 9"}, Row{"segv", "signal 11"},
                         Row{"hang", "no answer for 0.3 s"}}) {
    for (int i = 0; i < 30; ++i) workers->Submit(i, "x");
    workers->Submit(30, row.harm);
    // Whichever rank gets these, one of them is not rank 0.
    for (int i = 31; i < 39; ++i)
      workers->Submit(i, std::string("remote ") + row.harm);
    const auto answers = Collect(*workers);
    Expect(answers.size() == 39, "every request has its reply");
    Expect(answers.at(30) == row.death, answers.at(30));
    int deaths = 0;
    for (const auto& [ticket, answer] : answers) deaths += answer == row.death;
    Expect(deaths >= 2, std::string("a death elsewhere by ") + row.harm);
    Expect(workers->workers() == kJobs * session.size(), "all are replaced");
  }
}

void TestCancelling(MpiSession& session) {
  const auto workers = session.MakeWorkers("", 0);
  for (int i = 0; i < 400; ++i) workers->Submit(i, "nap");
  // Let them go on ahead.
  workers->Wait(50);
  workers->CancelWaiting();
  workers->CancelWaiting();
  // Also those that ranks had in advance.
  const auto answers = Collect(*workers);
  Expect(answers.size() <= 3U * static_cast<unsigned>(workers->workers()),
         "only what was begun is answered");
  workers->Submit(7, "again");
  Expect(Collect(*workers).at(7) == "niaga", "and more is done afterwards");
}

/// The last: what has begun here would never end.
void LeaveBusy(MpiSession& session) {
  const auto workers = session.MakeWorkers("", 0);
  for (int i = 0; i < 50; ++i) workers->Submit(i, "hang");
  workers->Wait(50);
}

double CpuSeconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) +
         1e-9 * static_cast<double>(time.tv_nsec);
}

/// What a rank costs that has nothing to do; shown, and never asserted.
void ReportIdling(MpiSession& session) {
  const auto workers = session.MakeWorkers("", 0);
  workers->Submit(0, "x");
  Collect(*workers);
  sleep(5);
}

int Run(const std::string& test) {
  if (!MpiSession::IsUnderMpi()) {
    fmt::print(stderr, "start it by mpirun, with two ranks or more\n");
    return 1;
  }
  MpiSession session;
  if (const auto failure = session.Join(kJobs, MakeTestWork)) {
    fmt::print(stderr, "{}\n", *failure);
    return failure->find("without MPI") == std::string::npos ? 1 : 77;
  }
  if (session.rank() != 0) {
    const double before = CpuSeconds();
    session.Serve();
    if (test == "idle")
      fmt::print("rank {}: {:.1f} ms of CPU in 5 s\n", session.rank(),
                 1000 * (CpuSeconds() - before));
    return 0;
  }
  if (test == "idle") {
    ReportIdling(session);
  } else if (test != "unused") {
    TestEqualReplies(session);
    TestPlaces(session);
    TestAnotherSetup(session);
    TestDeaths(session);
    TestCancelling(session);
    LeaveBusy(session);
  }
  return failures == 0 ? 0 : 1;
}

}  // namespace
}  // namespace plsc

int main(int count, char** words) {
  return plsc::Run(count > 1 ? words[1] : "all");
}
