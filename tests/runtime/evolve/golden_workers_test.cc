// Final states from worker processes, as evolution has them: the same bits
// from 1, 2 and 4 of them as from this process.

#include <catch2/catch.hpp>
#include <map>
#include <string>

#include "runtime/workers/worker_pool.h"
#include "tests/sim/golden_robots.h"

namespace plsc {
namespace {

constexpr int kPatience = 1000;  // ms

TEST_CASE("Worker processes end lives in the same states", "[workers][slow]") {
  const auto lives = test::GoldenLives();
  std::map<int, std::string> expected;
  for (std::size_t i = 0; i < lives.size(); ++i)
    expected[static_cast<int>(i)] = std::to_string(test::HashOf(lives[i]));
  for (const int workers : {1, 2, 4}) {
    CAPTURE(workers);
    WorkerPool pool(workers, [&](const std::string& request) {
      return std::to_string(test::HashOf(lives.at(std::stoul(request))));
    });
    for (std::size_t i = 0; i < lives.size(); ++i)
      pool.Submit(static_cast<int>(i), std::to_string(i));
    std::map<int, std::string> answers;
    while (pool.outstanding() > 0 && !pool.failure())
      for (const Reply& reply : pool.Wait(kPatience))
        answers[reply.ticket] = reply.answer.value_or(reply.death);
    CHECK(answers == expected);
  }
}

}  // namespace
}  // namespace plsc
