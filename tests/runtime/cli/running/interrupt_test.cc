#include "runtime/cli/running/interrupt.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

TEST_CASE("a signal is remembered while somebody asks for it", "[interrupt]") {
  for (const int signal : {SIGINT, SIGTERM}) {
    const cli::InterruptHandler handler;
    CHECK(!cli::InterruptHandler::is_interrupted());
    std::raise(signal);
    CHECK(cli::InterruptHandler::is_interrupted());
  }
  const cli::InterruptHandler handler;  // begins anew
  CHECK(!cli::InterruptHandler::is_interrupted());
}

}  // namespace
}  // namespace plsc
