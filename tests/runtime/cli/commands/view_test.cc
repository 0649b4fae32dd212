#include <catch2/catch.hpp>
#include <filesystem>

#include "runtime/pages/page.h"
#include "tests/runtime/cli/run_plsc.h"
#include "tests/runtime/cli/tiny_run.h"

namespace plsc {
namespace {

using test::RunPlsc;

constexpr const char* kSecondLife = R"(plsc_scenario: 1
seasons:
  - {name: flat, terrain: flat, duration: 1 s, senses: {inclined: False}}
)";

TEST_CASE("view writes one page of all lives", "[view]") {
  if (!HasPages()) return;  // the next case is for this program then
  const test::TemporaryFolder folder;
  const std::string page = folder / "p.html";
  const auto ran =
      RunPlsc({"view", "-", test::FinishedRun().path(), "1", "--scenario",
               folder.Write("s.yaml", kSecondLife), "-o", page},
              test::kPlasticText);
  INFO(ran.err);
  REQUIRE(ran.exit == 0);
  CHECK(ran.err == "wrote " + page + "\n");
  const std::string text = test::ReadFile(page);
  CHECK(text.find("<title>") != std::string::npos);
  CHECK(text.find("\"source\":\"standard input\"") != std::string::npos);
  CHECK(text.find("run.sqlite, robot 1") != std::string::npos);

  SECTION("the same again by the same bits, and nothing left beside it") {
    REQUIRE(RunPlsc({"view", "-", test::FinishedRun().path(), "1", "--scenario",
                     folder / "s.yaml", "-o", page},
                    test::kPlasticText)
                .exit == 0);
    CHECK(test::ReadFile(page) == text);
    CHECK(folder.Files() == std::vector<std::string>{"p.html", "s.yaml"});
  }
}

TEST_CASE("view says what it was built without", "[view]") {
  if (HasPages()) return;
  const auto ran = RunPlsc({"view", "-", "-o", "x.html"}, test::kPlasticText);
  CHECK(ran.exit == 1);
  CHECK(ran.err.find("npm") != std::string::npos);
}

TEST_CASE("view refuses before it lives anything", "[view]") {
  if (!HasPages()) return;
  const test::TemporaryFolder folder;
  const std::string genotype = folder.Write("g.pls", test::kPlasticText);
  struct Row {
    const char* why;
    std::vector<std::string> arguments;
    int exit;
    const char* message;
  };
  const std::vector<Row> rows = {
      {"no output", {genotype}, 2, "--output"},
      {"no input", {"-o", folder / "p.html"}, 2, "INPUT"},
      {"no folder", {genotype, "-o", folder / "no/p.html"}, 1, "cannot write"},
      {"a folder", {genotype, "-o", folder.path().string()}, 1, "is a folder"},
      {"its own input", {genotype, "-o", genotype}, 1, "the command reads it"},
      {"its own input, to be explained",
       {"--explain", genotype, "-o", genotype},
       1,
       "the command reads it"},
      {"no scenario",
       {genotype, "--scenario", folder / "no.yaml", "-o", folder / "p.html"},
       1,
       "cannot read"},
      {"no genotype",
       {folder / "no.pls", "-o", folder / "p.html"},
       1,
       "cannot"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      std::vector<std::string> arguments = {"view"};
      arguments.insert(arguments.end(), row.arguments.begin(),
                       row.arguments.end());
      const auto ran = RunPlsc(arguments);
      CHECK(ran.exit == row.exit);
      INFO(ran.err);
      CHECK(ran.err.find(row.message) != std::string::npos);
      CHECK(folder.Files() == std::vector<std::string>{"g.pls"});
    }
  }
}

TEST_CASE("view warns of a life that is not the stored one", "[view]") {
  if (!HasPages()) return;
  const test::TemporaryFolder folder;
  const std::string copy = test::ChangedRun(
      folder, "UPDATE simulation SET state_hash = '00000000000000ff'");
  const auto ran = RunPlsc({"view", copy, "-o", folder / "p.html"});
  CHECK(ran.exit == 0);
  CHECK(ran.err.find("is not, to the last bit") != std::string::npos);
  CHECK(test::ReadFile(folder / "p.html").find("is not, to the last bit") !=
        std::string::npos);
}

}  // namespace
}  // namespace plsc
