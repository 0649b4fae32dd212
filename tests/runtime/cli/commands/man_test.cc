#include <catch2/catch.hpp>
#include <filesystem>

#include "runtime/cli/arguments/command_description.h"
#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

using test::RunPlsc;

TEST_CASE("man prints the page of a command", "[cli][man]") {
  const auto page = RunPlsc({"man"});
  CHECK(page.exit == 0);
  CHECK(page.out.find(".TH PLSC 1 ") != std::string::npos);
  CHECK(RunPlsc({"man", "trim"}).out.find(".TH PLSC-TRIM 1 ") !=
        std::string::npos);
  CHECK(RunPlsc({"man", "study", "run"}).out.find(".TH PLSC-STUDY-RUN 1 ") !=
        std::string::npos);
  const auto unknown = RunPlsc({"man", "trem"});
  CHECK(unknown.exit == 2);
  CHECK(unknown.err.find("did you mean 'trim'?") != std::string::npos);
}

TEST_CASE("man --all writes a page a command", "[cli][man]") {
  const test::TemporaryFolder folder;
  const std::string pages = folder / "man/man1";
  CHECK(RunPlsc({"man", "--all", pages}).exit == 0);
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(pages)) {
    CHECK(entry.path().extension() == ".1");
    ++count;
  }
  const auto root = cli::DescribeCommandLine();
  CHECK(count == cli::AllCommands(root).size());
  CHECK(test::ReadFile(pages + "/plsc-trim.1") == RunPlsc({"man", "trim"}).out);
  const std::string file = folder.Write("file", "x");
  CHECK(RunPlsc({"man", "--all", file}).exit == 1);
  CHECK(test::ReadFile(file) == "x");
  CHECK(RunPlsc({"man", "trim", "--all", pages}).exit == 2);
}

}  // namespace
}  // namespace plsc
