#include "runtime/workers/mpi_server.h"

#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <map>
#include <string>
#include <vector>

#include "tests/runtime/workers/fake_link.h"

namespace plsc {

using test::FakeLink;

namespace {

std::string BytesOf(double number) {
  return {reinterpret_cast<const char*>(&number), sizeof number};
}

/// All that a rank with one worker tells rank 0, which ends it when it hears
/// `last`.
std::vector<RankWords> Serve(const std::vector<RankWords>& orders,
                             RankWord last, const Work& work) {
  std::vector<RankWords> told;
  FakeLink link(1, 2, [&](FakeLink& self, int rank, RankWords words) {
    CHECK(rank == 0);
    const bool is_last = words.word == last;
    told.push_back(std::move(words));
    if (is_last) self.Say(0, RankWord::kEnd);
  });
  link.Say(0, RankWord::kBegin, 0, BytesOf(0.2));
  for (const RankWords& order : orders)
    link.Say(0, order.word, order.number, order.text);
  WorkerPool pool(1, work);
  RankServer(link, pool).Serve();
  return told;
}

std::string Echo(const std::string& text) {
  if (text == "kill") raise(SIGKILL);
  if (text == "hang")
    while (true) pause();
  return "<" + text + ">";
}

const RankWords kHello = {RankWord::kHello, 1, ProgramVersion()};
const RankWords kBye = {RankWord::kBye, 0, ""};

}  // namespace

TEST_CASE("A rank says hello, answers, and says bye", "[mpi]") {
  CHECK(Serve(
            {
                {RankWord::kWork, 5, "five"},
                {RankWord::kWork, 4, "four"},
            },
            RankWord::kAnswer, Echo) ==
        std::vector<RankWords>{kHello, {RankWord::kAnswer, 5, "<five>"}, kBye});
}

TEST_CASE("A rank tells of deaths, and of workers that hang", "[mpi]") {
  CHECK(
      Serve({{RankWord::kWork, 7, "kill"}}, RankWord::kDeath, Echo) ==
      std::vector<RankWords>{kHello, {RankWord::kDeath, 7, "signal 9"}, kBye});
  CHECK(Serve({{RankWord::kWork, 8, "hang"}}, RankWord::kDeath, Echo) ==
        std::vector<RankWords>{
            kHello, {RankWord::kDeath, 8, "no answer for 0.2 s"}, kBye});
}

TEST_CASE("What a rank has not begun can be taken back", "[mpi]") {
  CHECK(Serve({{RankWord::kWork, 1, "one"},
               {RankWord::kWork, 2, "two"},
               {RankWord::kCancel, 0, ""}},
              RankWord::kAllCancelled,
              Echo) == std::vector<RankWords>{kHello,
                                              {RankWord::kCancelled, 1, ""},
                                              {RankWord::kCancelled, 2, ""},
                                              {RankWord::kAllCancelled, 0, ""},
                                              kBye});
}

TEST_CASE("A rank says so when it can have no worker any more", "[mpi]") {
  rlimit before{};
  REQUIRE(getrlimit(RLIMIT_NOFILE, &before) == 0);
  std::vector<RankWords> told;
  FakeLink link(1, 2, [&](FakeLink& self, int, RankWords words) {
    if (words.word == RankWord::kFailure) self.Say(0, RankWord::kEnd);
    told.push_back(std::move(words));
  });
  link.Say(0, RankWord::kBegin, 0, BytesOf(0));
  link.Say(0, RankWord::kWork, 1, "kill");
  WorkerPool pool(1, Echo);
  // Too few to open another socket.
  const rlimit few = {4, before.rlim_max};
  REQUIRE(setrlimit(RLIMIT_NOFILE, &few) == 0);
  RankServer(link, pool).Serve();
  REQUIRE(setrlimit(RLIMIT_NOFILE, &before) == 0);
  CHECK(told ==
        std::vector<RankWords>{kHello,
                               {RankWord::kFailure, 0,
                                "cannot start a worker: Too many open files"},
                               kBye});
}

}  // namespace plsc
