#include "runtime/study/study_folder.h"

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/runtime/store/stored_run.h"
#include "tests/runtime/study/small_study.h"

namespace plsc {

namespace {

using test::Scratch;
using test::SmallStudy;

using FolderNames = std::vector<std::string>;

}  // namespace

TEST_CASE("A study's folder keeps the study, and is found again",
          "[study_folder]") {
  const Scratch scratch;
  const std::string folder = scratch / "new/study";
  const Study study = SmallStudy();
  REQUIRE(PrepareFolder(folder, study) == std::nullopt);
  CHECK(test::ReadBytes(folder + "/study.yaml") == PrintStudy(study));
  CHECK(std::filesystem::is_directory(folder + "/plastic"));
  CHECK(std::filesystem::is_directory(folder + "/baseline"));
  CHECK(RunPath(folder, study, {1, 2}) == folder + "/baseline/2.sqlite");
  const Expected<Study, Failure> found = StudyIn(folder);
  REQUIRE(found);
  CHECK(*found == study);
  CHECK(PrepareFolder(folder, study) == std::nullopt);
}

TEST_CASE("The folder of another study is refused unchanged",
          "[study_folder]") {
  const Scratch scratch;
  const std::string folder = scratch / "study";
  const Study study = SmallStudy();
  REQUIRE(PrepareFolder(folder, study) == std::nullopt);
  struct Row {
    const char* why;
    std::function<void(Study&)> change;
    const char* part;
  };
  const std::vector<Row> rows = {
      {"a key of an experiment",
       [](Study& other) { other.experiments[1].experiment.mutation = 0.5; },
       "'mutation: 0.8', and here 'mutation: 0.5'"},
      {"the seed", [](Study& other) { other.seed = 8; },
       "line 3 of its study.yaml is 'seed: 7', and here 'seed: 8'"},
      {"an experiment less", [](Study& other) { other.experiments.pop_back(); },
       "is 'baseline:', and here missing"}};
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      Study other = study;
      row.change(other);
      const auto failure = PrepareFolder(folder, other);
      REQUIRE(failure);
      CHECK(failure->text.find("is the folder of another study") !=
            std::string::npos);
      INFO(failure->text);
      CHECK(failure->text.find(row.part) != std::string::npos);
      CHECK(test::ReadBytes(folder + "/study.yaml") == PrintStudy(study));
    }
  }
}

TEST_CASE("A folder of something else is not filled", "[study_folder]") {
  const Scratch scratch;
  std::filesystem::create_directory(scratch.path() / "home");
  test::WriteBytes(scratch / "home/letter.txt", "Dear");
  const auto failure = PrepareFolder(scratch / "home", SmallStudy());
  REQUIRE(failure);
  CHECK(failure->text.find("is no study's folder") != std::string::npos);
  CHECK(std::distance(
            std::filesystem::directory_iterator(scratch.path() / "home"),
            std::filesystem::directory_iterator()) == 1);
  // An empty one is.
  std::filesystem::create_directory(scratch.path() / "empty");
  CHECK(PrepareFolder(scratch / "empty", SmallStudy()) == std::nullopt);
}

TEST_CASE("A folder that cannot be made or read is told", "[study_folder]") {
  const Scratch scratch;
  test::WriteBytes(scratch / "file", "");
  const auto failure = PrepareFolder(scratch / "file/study", SmallStudy());
  REQUIRE(failure);
  CHECK(failure->text.find("cannot create") == 0);
  CHECK(
      StudyIn(scratch / "nothing").error().text.find("is no study's folder") !=
      std::string::npos);
  REQUIRE(PrepareFolder(scratch / "study", SmallStudy()) == std::nullopt);
  test::WriteBytes(scratch / "study/study.yaml", "experiments: 5\n");
  CHECK(StudyIn(scratch / "study").error().text.find("is damaged") !=
        std::string::npos);
}

TEST_CASE("Of many processes that begin at once, all agree on one study",
          "[study_folder]") {
  for (int round = 0; round < 10; ++round) {
    const Scratch scratch;
    const std::string folder = scratch / "study";
    // Even ones have one study, odd ones another.
    std::vector<pid_t> children;
    for (unsigned i = 0; i < 8; ++i) {
      const pid_t child = fork();
      if (child == 0) {
        Study study = SmallStudy();
        study.seed = i % 2;
        _exit(PrepareFolder(folder, study) ? 1 : 0);
      }
      children.push_back(child);
    }
    std::vector<int> statuses(2);  // how many were refused, by study
    for (std::size_t i = 0; i < children.size(); ++i) {
      int status = 0;
      waitpid(children[i], &status, 0);
      REQUIRE(WIFEXITED(status));
      statuses[i % 2] += WEXITSTATUS(status);
    }
    const Expected<Study, Failure> winner = StudyIn(folder);
    REQUIRE(winner);
    CHECK(statuses[winner->seed] == 0);
    CHECK(statuses[1 - winner->seed] == 4);
    FolderNames files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      files.push_back(entry.path().filename());
    CHECK(files.size() == 3);  // the study and two experiments
  }
}

TEST_CASE("A folder that is another study's, or gone, is noticed",
          "[study_folder]") {
  const Scratch scratch;
  const std::string folder = scratch / "study";
  const Study study = SmallStudy();
  REQUIRE(PrepareFolder(folder, study) == std::nullopt);
  CHECK(CheckFolder(folder, study) == std::nullopt);
  Study other = study;
  other.seed = study.seed + 1;
  CHECK(CheckFolder(folder, other).value_or("").text.find("another study") !=
        std::string::npos);
  std::filesystem::rename(folder, scratch / "moved");
  CHECK(CheckFolder(folder, study) ==
        "cannot read '" + folder + "/study.yaml'");
}

TEST_CASE("A folder that cannot be prepared leaves no folders behind",
          "[study_folder]") {
  const Scratch scratch;
  const Study study = SmallStudy();
  // In the place of a folder that the study needs.
  std::filesystem::create_directory(scratch / "study");
  test::WriteBytes(scratch / "study/study.yaml", PrintStudy(study));
  test::WriteBytes(scratch / "study/baseline", "a file");
  CHECK(PrepareFolder(scratch / "study", study)
            .value_or("")
            .text.find("cannot create '" + (scratch / "study/baseline") +
                       "'") == 0);
  CHECK_FALSE(std::filesystem::exists(scratch / "study/plastic"));
  // What is planted under the names that a study.yaml could have before it is
  // whole is neither followed nor deleted.
  const std::string planted =
      scratch / ("new/study.yaml." + std::to_string(getpid()));
  std::filesystem::create_directory(scratch / "new");
  test::WriteBytes(planted, "kept");
  REQUIRE(PrepareFolder(scratch / "new", study) == std::nullopt);
  CHECK(test::ReadBytes(planted) == "kept");
}

}  // namespace plsc
