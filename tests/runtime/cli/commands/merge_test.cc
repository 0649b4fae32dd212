#include <catch2/catch.hpp>

#include <filesystem>

#include "tests/runtime/cli/run_plsc.h"

namespace plsc::test {
namespace {

const std::string kMergeHead = "plsc 1\nalphabet plasticoding 1\n";

// Three versions in a folder.
struct Versions {
  TemporaryFolder folder;
  std::string base;
  std::string ours;
  std::string theirs;

  Versions(const std::string& b, const std::string& o, const std::string& t)
      : base(folder.Write("base.pls", b)),
        ours(folder.Write("ours.pls", o)),
        theirs(folder.Write("theirs.pls", t)) {}

  Ran Merge(std::vector<std::string> options = {}) const {
    std::vector<std::string> arguments{"merge", base, ours, theirs};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return RunPlsc(arguments);
  }
};

TEST_CASE("merge prints, or writes where it is told to", "[cli][merge]") {
  const std::string merged = kMergeHead + "let a = 2\nlet b = 2\n";
  const Versions versions(kMergeHead + "let a = 1\nlet b = 1\n",
                          kMergeHead + "let a = 2\nlet b = 1\n",
                          kMergeHead + "let a = 1\nlet b = 2\n");
  const Ran printed = versions.Merge();
  CHECK(printed.exit == 0);
  CHECK(printed.out == merged);
  CHECK(printed.err.empty());
  const std::string output = versions.folder / "merged.pls";
  CHECK(versions.Merge({"-o", output}).exit == 0);
  CHECK(ReadFile(output) == merged);
  CHECK(versions.Merge({"--write-ours"}).exit == 0);
  CHECK(ReadFile(versions.ours) == merged);
}

TEST_CASE("merge answers 1 and writes markers where there are conflicts",
          "[cli][merge]") {
  const Versions versions(kMergeHead + "let a = 1\n",
                          kMergeHead + "let a = 2\n",
                          kMergeHead + "let a = 3\n");
  const Ran ran =
      versions.Merge({"--driver", "-L", "3", "-P", "robots/a.pls", "--label",
                      "main", "--label", "start", "--label", "side"});
  CHECK(ran.exit == 1);
  CHECK(ran.out.empty());
  CHECK(ran.err ==
        "robots/a.pls:3: conflict: let a: 'let a = 1' is 'let a = 2' in main "
        "and 'let a = 3' in side\n");
  CHECK(ReadFile(versions.ours) ==
        kMergeHead +
            "<<< main\nlet a = 2\n||| start\nlet a = 1\n===\nlet a = 3\n"
            ">>> side\n");
}

TEST_CASE("merge answers 1 where both sides together are wrong",
          "[cli][merge]") {
  const Versions versions(
      kMergeHead + "sense hot: bool\n", kMergeHead,
      kMergeHead +
          "sense hot: bool\nrule B -> if hot = True then { T(0.5) }\n");
  const Ran ran = versions.Merge();
  CHECK(ran.exit == 1);
  CHECK(ran.err.find("error[P2005]") != std::string::npos);
  CHECK(ran.err.find("what both sides made together is wrong") !=
        std::string::npos);
}

TEST_CASE("merge answers 2 and writes nothing if a version is broken",
          "[cli][merge]") {
  struct Row {
    const char* why;
    std::string text;
  };
  const std::vector<Row> rows = {
      {"an error", kMergeHead + "rule B -> {\n"},
      {"empty", ""},
      {"binary", std::string("\0\x01\xff", 3)},
      {"unresolved",
       kMergeHead + "<<<<<<< ours\nlet a = 1\n=======\n>>>>>>> b\n"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const Versions ours(kMergeHead, row.text, kMergeHead + "let a = 1\n");
      const Versions theirs(kMergeHead, kMergeHead + "let a = 1\n", row.text);
      for (const Versions* versions : {&ours, &theirs}) {
        const std::string before = ReadFile(versions->ours);
        const Ran ran = versions->Merge({"--write-ours"});
        CHECK(ran.exit == 2);
        CHECK(ran.err.find("error[P") != std::string::npos);
        CHECK(ran.err.find("not merged") != std::string::npos);
        CHECK(ReadFile(versions->ours) == before);
      }
    }
  }
}

TEST_CASE("As a driver merge goes by lines if a version is broken",
          "[cli][merge]") {
  const Versions versions(kMergeHead + "let a = 1\n",
                          kMergeHead + "let a = 2\n",
                          kMergeHead + "let a = = 3\n");
  const Ran ran = versions.Merge({"--driver", "--path=robots/a.pls"});
  CHECK(ran.exit == 1);
  CHECK(ran.err.find(" --> robots/a.pls (theirs):3:9\n") != std::string::npos);
  CHECK(ran.err.find(versions.theirs) == std::string::npos);
  CHECK(ran.err.find("robots/a.pls:3: conflict: changed in different ways in "
                     "ours and theirs\n") != std::string::npos);
  CHECK(ReadFile(versions.ours) ==
        kMergeHead +
            "<<<<<<< ours\nlet a = 2\n||||||| base\nlet a = 1\n=======\n"
            "let a = = 3\n>>>>>>> theirs\n");
}

TEST_CASE("Lines of two correct sides must be correct together",
          "[cli][merge]") {
  const std::string sense = "sense hot: bool\n";
  const std::string right = "let b = 1\nlet c = 1\nlet d = 1\n";
  const std::string wrong = "let b = 1\nlet c = = 1\nlet d = 1\n";
  const std::string rule = "rule B -> if hot = True then { T(0.5) }\n";
  const Versions versions(kMergeHead + sense + wrong, kMergeHead + right,
                          kMergeHead + sense + right + rule);
  const Ran ran = versions.Merge({"--driver"});
  CHECK(ran.exit == 1);
  CHECK(ran.err.find("error[P2005]") != std::string::npos);
  CHECK(ReadFile(versions.ours) == kMergeHead + right + rule);
}

TEST_CASE("As a driver merge leaves binary files as ours", "[cli][merge]") {
  const std::string binary("\0\x01\xff", 3);
  for (const bool is_ours : {false, true}) {
    const Versions versions(kMergeHead, is_ours ? binary : kMergeHead,
                            is_ours ? kMergeHead : binary);
    const Ran ran = versions.Merge({"--driver"});
    CHECK(ran.exit == 2);
    CHECK(ran.err.find("not merged") != std::string::npos);
    CHECK(ReadFile(versions.ours) == (is_ours ? binary : kMergeHead));
  }
}

TEST_CASE("merge answers 2 to paths that cannot be", "[cli][merge]") {
  const Versions versions(kMergeHead, kMergeHead + "let a = 1\n", kMergeHead);
  const std::string folder = versions.folder.path().string();
  CHECK(RunPlsc({"merge", versions.base, versions.ours, folder}).exit == 2);
  CHECK(RunPlsc({"merge", versions.base, versions.ours, "none.pls"}).exit == 2);
  CHECK(versions.Merge({"-o", folder}).exit == 2);
  CHECK(versions.Merge({"-o", versions.theirs}).exit == 2);
  CHECK(ReadFile(versions.theirs) == kMergeHead);
  CHECK(RunPlsc({"merge", versions.base, versions.ours}).exit == 2);
  CHECK(versions.Merge({"--driver", "-o", "x"}).exit == 2);
  CHECK(versions.Merge({"-L", "0"}).exit == 2);
  std::filesystem::permissions(versions.ours,
                               std::filesystem::perms::owner_read);
  // The superuser may write there all the same.
  if (const Ran ran = versions.Merge({"--write-ours"}); ran.exit != 0) {
    CHECK(ran.exit == 2);
    CHECK(ran.err.find("cannot write") != std::string::npos);
  }
}

TEST_CASE("merge takes an empty base for nothing", "[cli][merge]") {
  const Versions versions("", kMergeHead + "let a = 1\n",
                          kMergeHead + "let b = 1\n");
  const Ran ran = versions.Merge();
  CHECK(ran.exit == 0);
  CHECK(ran.out == kMergeHead + "let a = 1\nlet b = 1\n");
}

TEST_CASE("merge lets arguments be out of range if told so", "[cli][merge]") {
  const Versions versions(kMergeHead, kMergeHead + "rule B -> { T(7) }\n",
                          kMergeHead + "let a = 1\n");
  CHECK(versions.Merge().exit == 2);
  CHECK(versions.Merge({"--allow-range"}).exit == 0);
}

}  // namespace
}  // namespace plsc::test
