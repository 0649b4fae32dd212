#include "runtime/study/claims_record.h"

#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <set>

#include "runtime/study/run_study.h"
#include "runtime/study/slice.h"
#include "runtime/study/study_folder.h"
#include "runtime/text/key.h"
#include "tests/runtime/store/stored_run.h"
#include "tests/runtime/study/small_study.h"

namespace plsc {

namespace {

using test::Scratch;

constexpr const char* kNow = "2026-11-30T12:00:00Z";
constexpr const char* kLater = "2026-12-01T12:00:00Z";

Claim Faster() {
  Claim claim;
  claim.name = "\"faster\": 100 %\n";  // a name that YAML would mistake
  claim.measure = "speed";
  claim.experiments = {"plastic", "baseline"};
  claim.seasons = {"flat"};
  claim.source = "Fig. 3";
  return claim;
}

Claim Bigger() {
  Claim claim = Faster();
  claim.name = "bigger";
  claim.measure = "size";
  return claim;
}

struct StatedStudy {
  Scratch scratch;
  std::string folder = scratch / "study";
  std::string file = folder + "/claims.yaml";
  Study study = test::SmallStudy();

  StatedStudy() { REQUIRE_FALSE(PrepareFolder(folder, study)); }
  void State(const std::string& now) {
    REQUIRE(StateClaims(folder, study, now) == std::nullopt);
  }
  void Execute(const std::string& only, int most = 0) {
    StudyOptions options;
    options.execute = [&](const RunTask& task) {
      return test::Execute(task, most);
    };
    options.on_step = [](const StudyRun&, StudyStep, const RunReport&) {};
    RunStudy(folder, study, RunsIn(study, only, {}), options);
  }
  ClaimsRecord Record() const {
    const auto record = ClaimsIn(folder);
    INFO((record ? "" : record.error().text));
    REQUIRE(record);
    return *record;
  }
  std::string Problem() const {
    const auto record = ClaimsIn(folder);
    return record ? "" : record.error().text;
  }
};

}  // namespace

TEST_CASE("Claims are kept with their time and hash, once", "[claims_record]") {
  StatedStudy fixture;
  fixture.State(kNow);
  CHECK_FALSE(std::filesystem::exists(fixture.file));
  CHECK(fixture.Record().empty());

  fixture.study.claims = {Faster(), Bigger()};
  fixture.State(kNow);
  const std::string bytes = test::ReadBytes(fixture.file);
  fixture.State(kLater);  // the same claims
  CHECK(test::ReadBytes(fixture.file) == bytes);
  CHECK_FALSE(std::filesystem::exists(fixture.folder + "/claims.2.yaml"));
  const ClaimsRecord record = fixture.Record();
  REQUIRE(record.size() == 1);
  CHECK(record[0].claims == fixture.study.claims);
  CHECK(record[0].stated == kNow);
  CHECK(record[0].hash == Hex(KeyOf(PrintClaims(fixture.study.claims, 0))));
  CHECK(record[0].runs == 4);
  CHECK(record[0].runs_begun == 0);
  CHECK(WhenStated(record[0]) == "before the first run");
  // A claim makes no other study.
  CHECK(PrepareFolder(fixture.folder, fixture.study) == std::nullopt);
  CHECK(StudyIn(fixture.folder)->claims.empty());
}

TEST_CASE("Claims that change are added with how many runs there were",
          "[claims_record]") {
  StatedStudy fixture;
  fixture.study.claims = {Faster(), Bigger()};
  fixture.State(kNow);
  fixture.Execute("plastic/1");
  fixture.Execute("plastic/2", 5);
  Claim less = Faster();
  less.kind = ClaimKind::kLess;
  fixture.study.claims = {less, Bigger()};
  fixture.State(kLater);
  fixture.study.claims.clear();
  fixture.State(kLater);
  fixture.study.claims = {Bigger()};
  fixture.State(kLater);

  const ClaimsRecord record = fixture.Record();
  REQUIRE(record.size() == 4);
  CHECK(record[0].claims[0] == Faster());
  CHECK(WhenStated(record[1]) == "after 2 of 4 runs had begun (1 was done)");
  CHECK(record[2].claims.empty());
  const auto stated = StatedClaims({record[0], record[1]});
  REQUIRE(stated.size() == 3);
  CHECK(stated[0].claim == less);
  CHECK(stated[0].since == 1);
  CHECK(stated[1].claim == Bigger());
  CHECK(stated[1].since == 0);
  CHECK(stated[2].claim == Faster());
  CHECK(stated[2].withdrawn == 1);
  // One that was withdrawn and made again stands since then only.
  const auto all = StatedClaims(record);
  REQUIRE(all.size() == 4);
  CHECK(all[0].since == 3);
  CHECK_FALSE(all[0].withdrawn);
}

TEST_CASE("A record that was changed is told and left", "[claims_record]") {
  StatedStudy fixture;
  fixture.study.claims = {Faster()};
  fixture.State(kNow);
  const std::string bytes = test::ReadBytes(fixture.file);
  for (std::size_t i = 0; i < bytes.size(); i += 7) {
    CAPTURE(i);
    std::string other = bytes;
    other[i] ^= 1;
    test::WriteBytes(fixture.file, other);
    CHECK(fixture.Problem().find("changed by hand") != std::string::npos);
    CHECK(StateClaims(fixture.folder, fixture.study, kLater) != std::nullopt);
    CHECK(test::ReadBytes(fixture.file) == other);
  }
  test::WriteBytes(fixture.file, bytes.substr(0, bytes.size() / 2));
  CHECK_FALSE(fixture.Problem().empty());
  test::WriteBytes(fixture.file, bytes + "# more\n");
  CHECK_FALSE(fixture.Problem().empty());
  test::WriteBytes(fixture.file, "");
  CHECK_FALSE(fixture.Problem().empty());
  test::WriteBytes(fixture.file, bytes);
  CHECK(fixture.Problem().empty());
}

TEST_CASE("A version that is gone, or of another folder, is noticed",
          "[claims_record]") {
  StatedStudy fixture;
  fixture.study.claims = {Faster()};
  fixture.State(kNow);
  fixture.study.claims = {Bigger()};
  fixture.State(kLater);
  const std::string first = test::ReadBytes(fixture.file);
  std::filesystem::remove(fixture.file);
  CHECK(fixture.Problem().find("claims.yaml' is missing") != std::string::npos);
  StatedStudy other;
  other.study.claims = {Faster()};
  other.State(kLater);
  test::WriteBytes(fixture.file, test::ReadBytes(other.file));
  CHECK(fixture.Problem().find("does not follow") != std::string::npos);
  test::WriteBytes(fixture.file, first);
  CHECK(fixture.Problem().empty());
}

TEST_CASE("Of many processes that state claims at once, each one's are kept",
          "[claims_record]") {
  for (int round = 0; round < 5; ++round) {
    StatedStudy fixture;
    std::vector<pid_t> children;
    for (unsigned i = 0; i < 8; ++i) {
      const pid_t child = fork();
      if (child == 0) {
        fixture.study.claims = {i % 2 == 0 ? Faster() : Bigger()};
        _exit(StateClaims(fixture.folder, fixture.study, kNow) ? 1 : 0);
      }
      children.push_back(child);
    }
    for (const pid_t child : children) {
      int status = 0;
      waitpid(child, &status, 0);
      CHECK(status == 0);
    }
    std::set<std::string> names;
    for (const ClaimsVersion& version : fixture.Record())
      names.insert(version.claims.at(0).name);
    CHECK(names.size() == 2);
    // Nothing else is left lying there.
    std::size_t files = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(fixture.folder))
      files += entry.is_regular_file() ? 1 : 0;
    CHECK(files == fixture.Record().size() + 1);
  }
}

}  // namespace plsc
