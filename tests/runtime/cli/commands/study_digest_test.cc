// A study without its stores says what it said with them, lives that were lived
// again included.

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

using Json = nlohmann::json;
using test::RunPlsc;

const char* const kTwoSeasons = R"(plsc_study: 1
name: tiny
seed: 3
repetitions: 2
base:
  population: 4
  offspring: 2
  generations: 5
  profile: swift
  scenario:
    seasons:
      - {name: flat, terrain: flat, duration: 1 s}
      - {name: tilted, terrain: {tilted: 5 deg}, duration: 1 s}
experiments:
  plastic: {}
  baseline: {encoding: baseline}
claims:
  faster: {measure: speed, season: flat, greater: [plastic, baseline]}
  rolls: {measure: core_turns, season: flat, equal: [plastic, baseline]}
  shrinks: {measure: size, season: flat, experiment: plastic, minimum_before: 3}
)";

struct Folder {
  test::TemporaryFolder folder;
  std::string results = folder / "results";
  std::string digest = folder / "tiny.digest.json";

  Folder() {
    REQUIRE(RunPlsc({"study", "run", folder.Write("study.yaml", kTwoSeasons),
                     "-o", results, "--quiet"})
                .exit == 0);
  }
  void Relive() const {
    REQUIRE(RunPlsc({"relive", results, "--lives", "2", "--swap", "1",
                     "--engine-check", "--quiet"})
                .exit == 0);
  }
  void Keep() const {
    REQUIRE(RunPlsc({"study", "digest", results, "-o", digest, "--every", "3"})
                .exit == 0);
  }
};

Json ReportOf(const std::string& path) {
  const auto ran = RunPlsc({"report", path, "--format", "json"});
  INFO(ran.err);
  REQUIRE(ran.exit == 0);
  return Json::parse(ran.out);
}

/// Equal but for numbers, of which six digits are kept and then converted.
void CheckAlike(const Json& one, const Json& other) {
  if (one.is_number() && other.is_number()) {
    CHECK(one.get<double>() ==
          Approx(other.get<double>()).epsilon(1e-5).margin(1e-6));
    return;
  }
  REQUIRE(one.type() == other.type());
  REQUIRE(one.size() == other.size());
  if (!one.is_structured()) CHECK(one == other);
  for (auto a = one.begin(), b = other.begin(); a != one.end(); ++a, ++b)
    if (one.is_structured()) CheckAlike(*a, *b);
}

}  // namespace

TEST_CASE("A digest's report has the stores' boxes, tests, swaps and claims",
          "[study]") {
  const Folder study;
  study.Relive();
  study.Keep();
  const Json stores = ReportOf(study.results);
  const Json digest = ReportOf(study.digest);
  bool has_relived = false;
  for (const Json& one : stores["finals"])
    has_relived = has_relived || one["told"] == "relived";
  CHECK(has_relived);
  CHECK_FALSE(stores["swaps"].empty());
  // A course is judged by a curve without gaps.
  CHECK(stores["claims"][2]["recorded"]["runs"] == Json{2});
  for (const char* key : {"finals", "tests", "swaps", "claims"}) {
    INFO(key);
    CheckAlike(digest[key], stores[key]);
  }
  for (std::size_t run = 0; run < 4; ++run)
    CheckAlike(digest["runs"][run]["relived"], stores["runs"][run]["relived"]);
  CHECK(digest["relived"]["runs"] == 4);
  CHECK(digest["relived"]["command"].is_null());
  CHECK(RunPlsc({"report", study.digest, "--format", "text"}).out ==
        RunPlsc({"report", study.results, "--format", "text"}).out);
}

TEST_CASE("A digest keeps what was lived again when that is gone", "[study]") {
  const Folder study;
  study.Keep();
  CHECK(ReportOf(study.digest)["relived"]["runs"] == 0);
  study.Relive();
  study.Keep();
  const std::string text = test::ReadFile(study.digest);
  for (const char* run : {"plastic/1", "plastic/2", "baseline/1"})
    std::filesystem::remove(study.results + "/" + run + ".relived.sqlite");
  std::filesystem::remove(study.results + "/baseline/2.sqlite");
  study.Keep();
  CHECK(test::ReadFile(study.digest) == text);
}

TEST_CASE("One command makes tables and figures of what is there", "[report]") {
  const Folder study;
  study.Keep();
  const std::string files = study.folder / "paper/figures";
  const std::vector<std::string> command{"report", study.digest, "--format",
                                         "files",  "-o",         files};
  const auto first = RunPlsc(command);
  INFO(first.err);
  CHECK(first.exit == 0);
  CHECK(first.out.find("4 runs: 4 done; 3 claims: ") != std::string::npos);
  const auto read = [&](const char* name) {
    return test::ReadFile(files + "/" + name);
  };
  for (const char* name :
       {"claims.csv", "boxes.csv", "tests.csv", "swaps.csv", "runs.csv"})
    CHECK(read(name).starts_with("study,values,"));
  CHECK(read("tables.md").find("| shrinks |") != std::string::npos);
  const std::string boxes = read("boxes.svg");
  CHECK(boxes.find("class=\"run\"") != std::string::npos);
  CHECK(read("curves.svg").ends_with("</svg>\n"));
  CHECK(read("swaps.csv").find("relived") == std::string::npos);

  study.Relive();
  study.Keep();
  CHECK(RunPlsc(command).exit == 0);  // replaces its own
  CHECK(read("boxes.svg") != boxes);
  CHECK(read("runs.csv").find("relived,plastic/1") != std::string::npos);

  std::ofstream(files + "/runs.csv") << "name,grade\n";
  const auto refused = RunPlsc(command);
  CHECK(refused.exit == 1);
  CHECK(refused.err.find("runs.csv': it is no table that plsc made") !=
        std::string::npos);
  CHECK(RunPlsc({"report", study.digest, "--format", "files"}).exit == 2);
}

TEST_CASE("What stands in docs/paper is what its digest says", "[report]") {
  const test::TemporaryFolder folder;
  const std::string paper = test::InRepository("docs/paper");
  REQUIRE(RunPlsc({"report", paper + "/paper.digest.json", "--format", "files",
                   "-o", folder.path().string()})
              .exit == 0);
  for (const std::string& name : folder.Files()) {
    INFO("docs/paper/README.md has the command that makes " << name);
    CHECK(test::ReadFile(folder / name) == test::ReadFile(paper + "/" + name));
  }
}

TEST_CASE("Digests of a time without claims and relived values are read",
          "[study]") {
  const std::string older =
      test::InRepository("tests/data/digest_without_claims.json");
  const Json report = ReportOf(older);
  CHECK(report["runs"][0]["state"] == "done");
  CHECK(report["claims"].empty());
  CHECK(report["relived"]["runs"] == 0);
  CHECK(report["finals"].size() > 0);
}

}  // namespace plsc
