// What a study claims, through its commands: stated, changed, damaged,
// reported, kept in a digest. The runs are real and tiny.

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

using test::RunPlsc;

const char* const kClaimingStudy = R"(plsc_study: 1
name: tiny
seed: 3
repetitions: 2
base:
  population: 2
  offspring: 2
  generations: 2
  profile: swift
  scenario:
    seasons: [{name: flat, terrain: flat, duration: 1 s}]
experiments:
  plastic: {}
  baseline: {encoding: baseline}
claims:
  faster: {measure: speed, season: flat, greater: [plastic, baseline]}
)";

bool Tells(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

struct ClaimingFolder {
  test::TemporaryFolder folder;
  std::string results = folder / "results";

  test::Ran Run(const std::string& study, const std::string& only) const {
    return RunPlsc({"study", "run", folder.Write("study.yaml", study), "-o",
                    results, "--quiet", "--only", only});
  }
};

}  // namespace

TEST_CASE("claims are stated before the first run, and changes are told",
          "[study]") {
  const ClaimingFolder claiming;
  REQUIRE(claiming.Run(kClaimingStudy, "plastic/1").exit == 0);
  REQUIRE(claiming.Run(kClaimingStudy, "plastic/2").exit == 0);
  CHECK_FALSE(std::filesystem::exists(claiming.results + "/claims.2.yaml"));
  CHECK(Tells(RunPlsc({"study", "status", claiming.results}).out,
              "1 claim, stated 20"));

  std::string changed = kClaimingStudy;
  changed.replace(changed.find("greater"), 7, "less");
  REQUIRE(claiming.Run(changed, "baseline").exit == 0);
  const auto status = RunPlsc({"study", "status", claiming.results});
  CHECK(status.exit == 0);
  CHECK(Tells(status.out, " before the first run\nchanged to 1 claim, at 20"));
  CHECK(Tells(status.out, " after 2 of 4 runs had begun (2 were done)\n"));

  const auto report = RunPlsc({"report", claiming.results, "--format", "text"});
  CHECK(report.exit == 0);
  CHECK(Tells(report.out, "Speed: plastic < baseline, flat\n"));
  CHECK(Tells(report.out, "withdrawn 20"));
  CHECK(Tells(report.out, "2 claims: 2 too few runs\n"));
  const std::string kept = claiming.folder / "claims.txt";
  for (int i = 0; i < 2; ++i) {  // the second replaces the first
    const auto written =
        RunPlsc({"report", claiming.results, "--format", "text", "-o", kept});
    CHECK(written.exit == 0);
    CHECK(Tells(written.out, "4 runs: 4 done; 2 claims: 2 too few runs\n"));
  }
  CHECK(test::ReadFile(kept) == report.out);

  const std::string digest = claiming.folder / "tiny.digest.json";
  REQUIRE(RunPlsc({"study", "digest", claiming.results, "-o", digest}).exit ==
          0);
  // Named in several ways, a study claims once, and of all of its runs.
  const std::string run = claiming.results + "/plastic/2.sqlite";
  for (const std::vector<std::string>& named :
       std::vector<std::vector<std::string>>{{digest},
                                             {claiming.results, digest},
                                             {digest, claiming.results},
                                             {run, claiming.results}}) {
    std::vector<std::string> command{"report", "--format", "text"};
    command.insert(command.end(), named.begin(), named.end());
    CHECK(RunPlsc(command).out == report.out);
  }
}

TEST_CASE("a record of claims that was edited stops a study, and is told",
          "[study]") {
  const ClaimingFolder claiming;
  REQUIRE(claiming.Run(kClaimingStudy, "plastic/1").exit == 0);
  const std::string file = claiming.results + "/claims.yaml";
  std::string text = test::ReadFile(file);
  text.replace(text.find("greater"), 7, "less");
  std::ofstream(file) << text;
  const auto run = claiming.Run(kClaimingStudy, "plastic/2");
  CHECK(run.exit == 1);
  CHECK(Tells(run.err, "claims.yaml' is damaged or was changed by hand"));
  CHECK_FALSE(std::filesystem::exists(claiming.results + "/plastic/2.sqlite"));
  for (const auto& command : std::vector<std::vector<std::string>>{
           {"study", "status", claiming.results},
           {"study", "digest", claiming.results, "-o",
            claiming.folder / "x.json"},
           {"report", claiming.results, "--format", "json"}}) {
    const auto told = RunPlsc(command);
    INFO(command[1]);
    CHECK(told.exit == 1);
    CHECK(Tells(told.err, "changed by hand"));
  }
}

TEST_CASE("report has no claims to tell of what claims nothing", "[report]") {
  const ClaimingFolder claiming;
  const std::string study(kClaimingStudy);
  REQUIRE(
      claiming.Run(study.substr(0, study.find("claims:")), "plastic/1").exit ==
      0);
  const auto report = RunPlsc({"report", claiming.results, "--format", "text"});
  CHECK(report.exit == 1);
  CHECK(Tells(report.err, "claims anything"));
}

TEST_CASE("claims about seasons of a scenario's own file are checked",
          "[check]") {
  const test::TemporaryFolder folder;
  folder.Write("ground.yaml",
               "seasons: [{name: summer, terrain: flat, duration: 1 s}]\n");
  const std::string study = folder.Write(
      "study.yaml",
      "experiments: {a: {scenario: ground.yaml}, b: {scenario: ground.yaml}}\n"
      "claims: {c: {measure: size, season: winter, less: [a, b]}}\n");
  const auto wrong = RunPlsc({"check", study});
  CHECK(wrong.exit == 1);
  CHECK(Tells(wrong.err, "claim 'c': experiment 'a' has no season 'winter'"));
  std::string text = test::ReadFile(study);
  text.replace(text.find("winter"), 6, "summer");
  const auto right = RunPlsc({"check", folder.Write("study.yaml", text)});
  CHECK(right.exit == 0);
  CHECK(Tells(right.out, ", 1 claim\n"));
}

}  // namespace plsc
