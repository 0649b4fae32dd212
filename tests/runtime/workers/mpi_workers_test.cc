#include "runtime/workers/mpi_workers.h"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstring>
#include <map>
#include <set>
#include <string>

#include "runtime/workers/worker_setup.h"
#include "tests/runtime/workers/fake_link.h"
#include "tests/runtime/workers/worker_helpers.h"

namespace plsc {

using test::Collect;
using test::FakeLink;

namespace {

constexpr int kRemoteWorkers = 2;

/// Two ranks of which the second is played: it says hello, keeps requests
/// until Answer, and gives back those that none of its workers would have.
class PlayedRank {
 public:
  PlayedRank()
      : link(0, 2, [this](FakeLink& self, int rank, RankWords words) {
          CHECK(rank == 1);
          Obey(self, std::move(words));
        }) {}

  void Answer(int ticket) {
    REQUIRE(requests.erase(ticket) == 1);
    link.Say(1, RankWord::kAnswer, ticket, "there");
  }
  void AnswerAll() {
    while (!requests.empty()) Answer(requests.begin()->first);
  }

  FakeLink link;
  std::string version = ProgramVersion();
  std::map<int, std::string> requests;
  int cancels = 0;
  double limit = 0;

 private:
  void Obey(FakeLink& self, RankWords words) {
    if (words.word == RankWord::kBegin) {
      std::memcpy(&limit, words.text.data(), sizeof limit);
      self.Say(1, RankWord::kHello, kRemoteWorkers, version);
    }
    if (words.word == RankWord::kWork)
      requests[words.number] = std::move(words.text);
    if (words.word != RankWord::kCancel) return;
    ++cancels;
    while (requests.size() > kRemoteWorkers) {
      const int last = requests.rbegin()->first;
      requests.erase(last);
      self.Say(1, RankWord::kCancelled, last);
    }
    self.Say(1, RankWord::kAllCancelled);
  }
};

/// One worker at rank 0, which answers "here", some requests never.
struct OwnPool {
  WorkerPool pool = WorkerPool(1, WorkWithSetup([](const std::string& setup) {
                                 return [setup](const std::string& text) {
                                   while (text == "hang") pause();
                                   return setup + "here";
                                 };
                               }));
};

std::map<int, std::string> WaitForOwn(MpiWorkers& workers, std::size_t count) {
  std::map<int, std::string> answers;
  while (answers.size() < count)
    for (const Reply& reply : workers.Wait(test::kPatience))
      answers[reply.ticket] = reply.answer.value_or(reply.death);
  return answers;
}

}  // namespace

TEST_CASE("All ranks' workers count, and idle ones get work first", "[mpi]") {
  PlayedRank remote;
  OwnPool own;
  MpiWorkers workers(remote.link, own.pool, "setup", 30);
  CHECK(remote.limit == 30);
  CHECK(workers.workers() == 3);
  for (int i = 0; i < 3; ++i) workers.Submit(i, "x");
  CHECK(workers.busy() == 3);
  CHECK(workers.outstanding() == 3);
  CHECK(remote.requests.size() == 2);
  CHECK(remote.requests.begin()->second == RequestWithSetup("setup", "x"));
  remote.AnswerAll();
  CHECK(Collect(workers) == std::map<int, std::string>{
                                {0, "there"}, {1, "setuphere"}, {2, "there"}});
  CHECK(workers.busy() == 0);
}

TEST_CASE("Ranks get requests in advance only while there are many", "[mpi]") {
  PlayedRank remote;
  OwnPool own;
  MpiWorkers workers(remote.link, own.pool, "", 0);
  workers.Submit(0, "hang");
  workers.Submit(1, "hang");
  workers.Submit(2, "hang");
  // As many wait as there are workers: whoever is free first gets them.
  for (int i = 3; i < 6; ++i) workers.Submit(i, "x");
  CHECK(remote.requests.size() == 2);
  for (int i = 6; i < 20; ++i) workers.Submit(i, "x");
  CHECK(remote.requests.size() == 2 * kRemoteWorkers);
  CHECK(workers.busy() == 3);
  CHECK(workers.outstanding() == 20);
  remote.Answer(remote.requests.begin()->first);
  workers.Wait(0);
  CHECK(remote.requests.size() == 2 * kRemoteWorkers);
}

TEST_CASE("What ranks have in advance is taken back once", "[mpi]") {
  PlayedRank remote;
  OwnPool own;
  MpiWorkers workers(remote.link, own.pool, "", 0);
  for (int i = 0; i < 20; ++i) workers.Submit(i, "hang");
  CHECK(workers.outstanding() == 20);
  workers.CancelWaiting();
  workers.CancelWaiting();
  CHECK(remote.cancels == 1);
  // Until the rank has said so they are outstanding.
  CHECK(workers.outstanding() == 1 + 2 * kRemoteWorkers);
  workers.Wait(0);
  CHECK(workers.outstanding() == 1 + kRemoteWorkers);
  CHECK(remote.requests.size() == kRemoteWorkers);
  // Nothing more to take back.
  workers.CancelWaiting();
  CHECK(remote.cancels == 1);
}

TEST_CASE("Others do what a rank without workers had", "[mpi]") {
  PlayedRank remote;
  OwnPool own;
  MpiWorkers workers(remote.link, own.pool, "", 0);
  for (int i = 0; i < 10; ++i) workers.Submit(i, "x");
  remote.requests.clear();
  remote.link.Say(1, RankWord::kFailure, 0, "no more processes");
  const auto answers = WaitForOwn(workers, 10);
  for (const auto& [ticket, answer] : answers) CHECK(answer == "here");
  CHECK(workers.workers() == 1);
  CHECK_FALSE(workers.failure());
}

TEST_CASE("A rank with fewer workers gets fewer requests", "[mpi]") {
  PlayedRank remote;
  OwnPool own;
  MpiWorkers workers(remote.link, own.pool, "", 0);
  remote.link.Say(1, RankWord::kWorkers, 1);
  workers.Submit(0, "hang");
  workers.Wait(0);
  CHECK(workers.workers() == 2);
}

TEST_CASE("Deaths at other ranks are replies", "[mpi]") {
  PlayedRank remote;
  OwnPool own;
  MpiWorkers workers(remote.link, own.pool, "", 0);
  workers.Submit(3, "x");
  REQUIRE(remote.requests.contains(3));
  remote.link.Say(1, RankWord::kDeath, 3, "signal 9");
  const auto replies = workers.Wait(test::kPatience);
  REQUIRE(replies.size() == 1);
  CHECK_FALSE(replies[0].answer);
  CHECK(replies[0].death == "signal 9");
  CHECK(workers.outstanding() == 0);
}

TEST_CASE("Ranks of another version of plsc are refused", "[mpi]") {
  PlayedRank remote;
  remote.version = "plsc 0.0.1";
  OwnPool own;
  const MpiWorkers workers(remote.link, own.pool, "", 0);
  CHECK(workers.failure() ==
        "rank 1 runs plsc 0.0.1, and rank 0 " + ProgramVersion());
}

}  // namespace plsc
