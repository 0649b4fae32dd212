#include <catch2/catch.hpp>

#include "tests/runtime/cli/run_plsc.h"
#include "tests/runtime/cli/shell.h"

namespace plsc {
namespace {

using test::RunPlsc;

TEST_CASE("completion prints a script that its shell can read",
          "[cli][completion]") {
  const test::TemporaryFolder folder;
  for (const std::string shell : {"bash", "zsh", "fish"}) {
    CAPTURE(shell);
    const auto ran = RunPlsc({"completion", shell});
    CHECK(ran.exit == 0);
    CHECK(ran.err.empty());
    const std::string file = folder.Write("plsc." + shell, ran.out);
    if (!test::HasProgram(shell)) continue;
    const auto read = test::RunShell(shell + " -n " + file);
    CHECK(read.out == "");
    CHECK(read.status == 0);
  }
  CHECK(RunPlsc({"completion", "tcsh"}).exit == 2);
  CHECK(RunPlsc({"completion"}).exit == 2);
}

}  // namespace
}  // namespace plsc
