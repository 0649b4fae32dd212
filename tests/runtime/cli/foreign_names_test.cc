// Names that drive terminals and spreadsheets, through every command that
// prints names: none gets out as it is.

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

using test::ReadFile;
using test::RunPlsc;

const char* const kHostile = R"(plsc_experiment: 1
name: "=1+1\e[31m\nerror: forged"
population: 2
offspring: 2
generations: 2
scenario:
  name: "\e]0;title\a"
  seasons:
    - {name: -flat, terrain: flat, duration: 1 s}  # more is refused
)";

/// Nothing but printable characters and our own ends of lines; and no line
/// begins with what a name says.
void CheckHarmless(const std::string& text) {
  CAPTURE(text);
  CHECK(std::none_of(text.begin(), text.end(), [](unsigned char c) {
    return (c < 0x20 && c != '\n') || c == 0x7F;
  }));
  CHECK(text.find("\nerror: forged") == std::string::npos);
}

TEST_CASE("Names of runs and seasons are escaped in all texts",
          "[foreign_names]") {
  const test::TemporaryFolder folder;
  const std::string experiment = folder.Write("e.yaml", kHostile);
  const std::string run = folder / "run\x1B[31m.sqlite";
  const auto evolved =
      RunPlsc({"evolve", experiment, "-o", run, "--jobs", "1"});
  REQUIRE(evolved.exit == 0);
  CheckHarmless(evolved.out);
  CheckHarmless(evolved.err);
  const std::string robot = folder / "best.pls";
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{
           {"show", run},
           {"show", run, "best"},
           {"show", run, "99"},
           {"draw", run, "best"},
           {"replay", run, "best"},
           {"report", run, "--format", "json"},
           {"report", folder / "none\n\x1B"},
           {"view", run, "99", "-o", folder / "view.html"},
           {"export", run, "--csv", folder / "tables"},
           {"check", folder / "no\x1Bsuch\n.pls"},
           {"develop", folder / "no\x1Bsuch\n.pls"},
           {"evolve", experiment, "-o", run}}) {
    CAPTURE(arguments);
    const auto ran = RunPlsc(arguments);
    CheckHarmless(ran.out);
    CheckHarmless(ran.err);
  }
  CHECK(RunPlsc({"show", run})
            .out.find("=1+1\\x1b[31m\\nerror: forged (seed 1)") == 0);
}

TEST_CASE("Names in tables are no formulas", "[foreign_names]") {
  const test::TemporaryFolder folder;
  const std::string run = folder / "run.sqlite";
  REQUIRE(RunPlsc({"evolve", folder.Write("e.yaml", kHostile), "-o", run,
                   "--jobs", "1", "--quiet"})
              .exit == 0);
  REQUIRE(RunPlsc({"export", run, "--csv", folder / "tables"}).exit == 0);
  const std::string runs = ReadFile(folder / "tables/run.csv");
  CHECK(runs.find("\r\n\"'=1+1\x1B[31m\nerror: forged\",1,") !=
        std::string::npos);
  const std::string results = ReadFile(folder / "tables/results.csv");
  CHECK(results.find(",'-flat,") != std::string::npos);
  CHECK(results.find(",-flat") == std::string::npos);
  // What is measured stays a number, whatever its sign.
  CHECK(results.find("'-0") == std::string::npos);
}

TEST_CASE("A file's name in a diagnostic is escaped", "[foreign_names]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("a\x1B[31m\n.pls", "plsc 1\nrule\n");
  for (const char* command : {"check", "lint", "fmt", "develop"}) {
    CAPTURE(command);
    const auto ran = RunPlsc({command, file});
    CHECK(ran.exit == 1);
    CheckHarmless(ran.err);
    CHECK(ran.err.find("a\\x1b[31m\\n.pls:2:") != std::string::npos);
  }
}

}  // namespace
}  // namespace plsc
