#include "runtime/workers/worker_setup.h"

#include <catch2/catch.hpp>
#include <string>

namespace plsc {

TEST_CASE("Work is made once a setup", "[worker_setup]") {
  int made = 0;
  const Work work = WorkWithSetup([&](const std::string& setup) {
    ++made;
    return [setup](const std::string& text) { return setup + "|" + text; };
  });
  const std::string zeros("\0\n\xff", 3);
  CHECK(work(RequestWithSetup("", "")) == "|");
  CHECK(work(RequestWithSetup("a", "b")) == "a|b");
  CHECK(made == 2);
  CHECK(work(RequestWithSetup("a", zeros)) == "a|" + zeros);
  CHECK(work(RequestWithSetup("a", "")) == "a|");
  CHECK(made == 2);
  CHECK(work(RequestWithSetup(zeros, "ab")) == zeros + "|ab");
  // Only the latest is kept.
  CHECK(work(RequestWithSetup("a", "b")) == "a|b");
  CHECK(made == 4);
}

}  // namespace plsc
