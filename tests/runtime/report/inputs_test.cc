#include "runtime/report/inputs.h"

#include <catch2/catch.hpp>
#include <filesystem>

#include "runtime/study/study_folder.h"
#include "tests/runtime/store/stored_run.h"
#include "tests/runtime/study/small_study.h"

namespace plsc {
namespace {

namespace fs = std::filesystem;
using test::Scratch;

std::vector<std::string> Labels(const ReportInputs& inputs) {
  std::vector<std::string> labels;
  for (const ReportInput& run : inputs.runs) labels.push_back(run.label);
  return labels;
}

using Names = std::vector<std::string>;

/// A study's folder without any run.
struct Folder {
  Scratch scratch;
  std::string path = scratch / "study";
  Study study = test::SmallStudy();

  Folder() { REQUIRE(PrepareFolder(path, study) == std::nullopt); }
};

bool Has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("A study has all of its runs, also those that are missing",
          "[inputs]") {
  const Folder folder;
  for (const std::string& path : {folder.path, folder.path + "/"}) {
    const auto inputs = FindRuns({path});
    REQUIRE(inputs);
    CHECK(inputs->title == "small");
    CHECK(Labels(*inputs) ==
          Names{"plastic/1", "plastic/2", "baseline/1", "baseline/2"});
    CHECK(inputs->runs[2].experiment == "baseline");
    CHECK(inputs->runs[2].expected ==
          ExperimentOf(folder.study, StudyRun{1, 1}));
  }
}

TEST_CASE("One experiment of a study, and one run of it, know the study",
          "[inputs]") {
  const Folder folder;
  const std::string part = folder.path + "/baseline";
  CHECK(Labels(*FindRuns({part})) == Names{"baseline/1", "baseline/2"});
  test::WriteBytes(part + "/2.sqlite", "?");
  const auto single = FindRuns({part + "/2.sqlite"});
  REQUIRE(single);
  CHECK(single->title == "baseline/2");
  CHECK(Labels(*single) == Names{"baseline/2"});
  CHECK(single->runs[0].experiment == "baseline");
}

TEST_CASE("A run that is named twice is there once", "[inputs]") {
  const Folder folder;
  test::WriteBytes(folder.path + "/plastic/1.sqlite", "?");
  const auto inputs = FindRuns({folder.path + "/plastic/1.sqlite", folder.path,
                                folder.path + "/../study/plastic/1.sqlite"});
  REQUIRE(inputs);
  CHECK(Labels(*inputs) ==
        Names{"plastic/1", "plastic/2", "baseline/1", "baseline/2"});
}

TEST_CASE("Folders of runs and runs need no study", "[inputs]") {
  const Scratch scratch;
  for (const char* name : {"b.sqlite", "a.sqlite", "notes.txt"})
    test::WriteBytes(scratch / name, "?");
  const auto folder = FindRuns({scratch.path().string()});
  REQUIRE(folder);
  CHECK(Labels(*folder) == Names{"a.sqlite", "b.sqlite"});
  CHECK(folder->runs[0].experiment.empty());
  CHECK_FALSE(folder->runs[0].expected);
  const auto file = FindRuns({scratch / "notes.txt"});
  REQUIRE(file);
  CHECK(file->title == "notes.txt");  // what it is, reading tells
}

TEST_CASE("What has no runs is told with what to do", "[inputs]") {
  const Scratch scratch;
  fs::create_directory(scratch / "empty");
  test::WriteBytes(scratch / "study.yml", "plsc_study: 1");
  CHECK(
      Has(FindRuns({scratch / "none"}).error().text, "no such file or folder"));
  CHECK(Has(FindRuns({scratch / "empty"}).error().text, "has no runs"));
  CHECK(Has(FindRuns({scratch / "study.yml"}).error().text,
            "the folder that 'plsc study run' filled"));
  fs::create_directory(scratch / "broken");
  test::WriteBytes(scratch / "broken/study.yaml", "plsc_study: [");
  CHECK(Has(FindRuns({scratch / "broken"}).error().text, "is damaged"));
}

}  // namespace plsc
