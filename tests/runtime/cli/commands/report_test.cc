// Reports of real runs, tiny ones. What pages show is tested in a browser
// (tests/pages/report_test.mjs), what numbers are in tests/runtime/report.

#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "runtime/pages/page.h"
#include "tests/runtime/cli/run_plsc.h"
#include "tests/runtime/cli/tiny_run.h"

namespace plsc {
namespace {

using Json = nlohmann::json;
using test::FinishedRun;
using test::RunPlsc;

bool HasPart(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("report prints a run as JSON", "[report]") {
  const auto ran = RunPlsc({"report", FinishedRun().path(), "--format", "json",
                            "--measures", "speed,hinge_count"});
  CHECK(ran.exit == 0);
  CHECK(ran.err.empty());
  const Json report = Json::parse(ran.out);
  CHECK(report["single"] == true);
  CHECK(report["measures"].size() == 2);
  CHECK(report["measures"][1]["id"] == "hinge_count");
  CHECK(report["runs"][0]["state"] == "done");
  CHECK(report["runs"][0]["best"]["id"] ==
        FinishedRun().summary()["best"]["id"]);
  CHECK(report["made"]["at"].get<std::string>().ends_with("Z"));
}

TEST_CASE("report writes a page, and replaces it", "[report]") {
  const test::TemporaryFolder folder;
  const std::string page = folder.Write(
      "page.html",
      R"(<!DOCTYPE html><meta name="generator" content="plsc">before)");
  const auto ran = RunPlsc({"report", FinishedRun().path(), "-o", page});
  if (!HasPages()) {
    CHECK(ran.exit == 1);
    CHECK(HasPart(ran.err, "built without npm"));
    return;
  }
  CHECK(ran.exit == 0);
  CHECK(ran.out == page + ": 1 run: 1 done\n");
  const std::string text = test::ReadFile(page);
  CHECK(text.starts_with("<!DOCTYPE html>"));
  CHECK(HasPart(text, "\"plsc_report\":3"));
  CHECK(folder.Files() == std::vector<std::string>{"page.html"});

  const auto quiet =
      RunPlsc({"report", FinishedRun().path(), "-o", page, "--quiet"});
  CHECK(quiet.exit == 0);
  CHECK((quiet.out + quiet.err).empty());
}

TEST_CASE("report tells a damaged run and shows the others", "[report]") {
  const test::TemporaryFolder folder;
  const std::string bytes = test::ReadFile(FinishedRun().path());
  folder.Write("whole.sqlite", bytes);
  folder.Write("cut.sqlite", bytes.substr(0, bytes.size() / 2));
  folder.Write("text.sqlite", "plsc 1\n");
  const auto ran = RunPlsc({"report", folder.path().string(), "--format",
                            "json", "-o", folder / "out.json"});
  CHECK(ran.exit == 1);
  CHECK(HasPart(ran.err, "error: '" + (folder / "cut.sqlite") + "'"));
  CHECK(HasPart(ran.err, "error: '" + (folder / "text.sqlite") + "'"));
  CHECK(HasPart(ran.out, "3 runs: 1 done, 2 damaged"));
  const Json report = Json::parse(test::ReadFile(folder / "out.json"));
  CHECK(report["experiments"].size() == 1);
  CHECK(report["runs"][0]["state"] == "damaged");
  CHECK(report["runs"][0]["problem"].is_string());
  CHECK(report["curves"].size() > 0);

  const auto nothing =
      RunPlsc({"report", folder / "cut.sqlite", "-o", folder / "none.html"});
  CHECK(nothing.exit == 1);
  CHECK_FALSE(std::filesystem::exists(folder / "none.html"));
}

TEST_CASE("report refuses what it cannot do, and says why", "[report]") {
  const test::TemporaryFolder folder;
  const std::string run = FinishedRun().path();
  struct Row {
    const char* why;
    std::vector<std::string> arguments;
    int exit;
    std::string said;
  };
  const std::vector<Row> rows = {
      {"nothing named", {"report", "-o", "x.html"}, 2, "STUDY|RUN"},
      {"a page to nowhere", {"report", run}, 2, "add -o FILE"},
      {"an unknown measure",
       {"report", run, "-o", "x.html", "--measures", "sped"},
       2,
       "unknown measure 'sped'"},
      {"an unknown format", {"report", run, "--format", "pdf"}, 2, "--format"},
      {"no such file",
       {"report", folder / "none", "-o", folder / "x.html"},
       1,
       "no such file or folder"},
      {"a folder without runs",
       {"report", folder.path().string(), "-o", folder / "x.html"},
       1,
       "has no runs"},
      {"a page that cannot be written",
       {"report", run, "-o", folder / "none/x.html"},
       1,
       "cannot write"},
      {"JSON that cannot be written",
       {"report", run, "--format", "json", "-o", folder / "none/x.json"},
       1,
       "cannot write"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      if (!HasPages() && row.exit == 1 && row.said == "cannot write") return;
      const auto ran = RunPlsc(row.arguments);
      CHECK(ran.exit == row.exit);
      CHECK(HasPart(ran.err, row.said));
      CHECK(ran.out.empty());
      CHECK(folder.Files().empty());
    }
  }
}

TEST_CASE("A study that is not begun has nothing to report", "[report]") {
  const test::TemporaryFolder folder;
  std::filesystem::create_directory(folder / "study");
  folder.Write("study/study.yaml",
               "plsc_study: 1\nrepetitions: 1\nexperiments:\n  a: {}\n");
  const auto ran = RunPlsc({"report", folder / "study", "--format", "json"});
  CHECK(ran.exit == 1);
  CHECK(HasPart(ran.err, "none of these runs is begun yet"));
  CHECK(ran.out.empty());
}

}  // namespace plsc
