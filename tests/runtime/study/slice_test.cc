#include "runtime/study/slice.h"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "tests/runtime/study/small_study.h"

namespace plsc {

namespace {

std::vector<std::string> NamesIn(const Study& study, std::string_view only,
                                 const Shard& shard) {
  std::vector<std::string> names;
  for (const StudyRun& run : RunsIn(study, only, shard))
    names.push_back(RunName(study, run));
  return names;
}

using SliceNames = std::vector<std::string>;

}  // namespace

TEST_CASE("A shard is written K/N", "[slice]") {
  CHECK(ParseShard("2/8") == Shard{2, 8});
  CHECK(ParseShard("1/1") == Shard{1, 1});
  for (const char* wrong : {"", "2", "/8", "2/", "0/8", "9/8", "-1/8", "2/8/3",
                            "a/b", "2 /8", "1/1000001", "1/99999999999"}) {
    CAPTURE(wrong);
    CHECK_FALSE(ParseShard(wrong));
  }
}

TEST_CASE("Shards take runs in turn, every run once", "[slice]") {
  Study study = test::SmallStudy();
  CHECK(NamesIn(study, "", {1, 3}) == SliceNames{"plastic/1", "baseline/2"});
  CHECK(NamesIn(study, "", {2, 3}) == SliceNames{"plastic/2"});
  CHECK(NamesIn(study, "", {3, 3}) == SliceNames{"baseline/1"});
  CHECK(NamesIn(study, "", {5, 5}).empty());
  study.repetitions = 20;
  for (const int count : {1, 2, 3, 7, 8, 40}) {
    std::vector<int> taken(40);
    for (int number = 1; number <= count; ++number) {
      const auto runs = RunsIn(study, "", {number, count});
      CHECK(runs.size() >= static_cast<std::size_t>(40 / count));
      CHECK(runs.size() <= static_cast<std::size_t>(40 / count + 1));
      for (const StudyRun& run : runs)
        ++taken[run.experiment * 20 + static_cast<std::size_t>(run.repetition) -
                1];
    }
    CHECK(taken == std::vector<int>(40, 1));
  }
}

TEST_CASE("A slice is an experiment or a run by its name", "[slice]") {
  const Study study = test::SmallStudy();
  CHECK(NamesIn(study, "", {}).size() == 4);
  CHECK(NamesIn(study, "plastic", {}) == SliceNames{"plastic/1", "plastic/2"});
  CHECK(NamesIn(study, "baseline/2", {}) == SliceNames{"baseline/2"});
  // The shard is one of the whole study, so that jobs that are given the same
  // shard and different names do not overlap either.
  CHECK(NamesIn(study, "baseline", {1, 3}) == SliceNames{"baseline/2"});
}

TEST_CASE("A name that no run has is explained", "[slice]") {
  const Study study = test::SmallStudy();
  for (const char* right : {"", "plastic", "plastic/1", "baseline/2"})
    CHECK_FALSE(CheckOnly(study, right));
  CHECK(*CheckOnly(study, "plastik") ==
        "the study has no experiment 'plastik'; did you mean 'plastic'?");
  CHECK(*CheckOnly(study, "x/1") ==
        "the study has no experiment 'x'; it has plastic, baseline");
  for (const char* wrong :
       {"plastic/3", "plastic/0", "plastic/", "plastic/01", "plastic/1/1"})
    CHECK(*CheckOnly(study, wrong) ==
          "'plastic' has repetitions 1 to 2, as in 'plastic/1'");
}

}  // namespace plsc
