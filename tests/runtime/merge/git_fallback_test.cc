// Whatever the three versions are, git's merge with plsc as its driver loses
// nothing of either side; and names of files that look like options are names.

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "tests/runtime/merge/git_repository.h"
#include "tests/sanitizer.h"

namespace plsc::test {
namespace {

const std::string kHead = "plsc 1\nalphabet plasticoding 1\n";
const std::string kApart = "let b = 1\nlet c = 1\nlet d = 1\n";

// What a version can be, `what` being what its author wrote, at one of two
// places of the file.
std::string VersionOf(const std::string& kind, const std::string& first,
                      const std::string& last) {
  const std::string body =
      "let a = " + first + "\n" + kApart + "let e = " + last + "\n";
  if (kind == "correct") return kHead + body;
  if (kind == "typo") return kHead + "rule C -> { CC }\n" + body;
  if (kind == "newer") return "plsc 2\nalphabet plasticoding 1\n" + body;
  if (kind == "playlist") return "[playlist]\n" + body;
  return "";  // both sides added it, or one emptied it
}

const std::vector<std::string> kKinds = {"correct", "typo", "newer", "playlist",
                                         "empty"};

struct Case {
  std::string file;
  std::string base;
  std::string ours;
  std::string theirs;
  bool is_all_correct = false;
};

std::vector<Case> AllCases() {
  std::vector<Case> cases;
  std::size_t turn = 0;
  for (const std::string& base : kKinds) {
    for (const std::string& ours : kKinds) {
      for (const std::string& theirs : kKinds) {
        for (const bool is_apart : {false, true}) {
          Case one;
          one.file = fmt::format("-{} {} {} {}.pls", base, ours, theirs,
                                 is_apart ? "it's apart" : "$near");
          one.base = VersionOf(base, "1", "1");
          one.ours = VersionOf(ours, "11", "1");
          one.theirs = is_apart ? VersionOf(theirs, "1", "12")
                                : VersionOf(theirs, "12", "1");
          one.is_all_correct = ours == "correct" && theirs == "correct" &&
                               (base == "correct" || base == "empty");
          if (IsSampled(turn++)) cases.push_back(one);
        }
      }
    }
  }
  return cases;
}

void CommitSides(const GitRepository& repository,
                 const std::vector<Case>& cases) {
  const auto write = [&](const std::string Case::*side) {
    for (const Case& one : cases) repository.Write(one.file, one.*side);
  };
  write(&Case::base);
  repository.Commit("base");
  repository.Git("checkout -q -b theirs");
  write(&Case::theirs);
  repository.Commit("theirs");
  repository.Git("checkout -q main");
  write(&Case::ours);
  repository.Commit("ours");
}

// What git makes of the lines of a case by itself, and whether they conflict.
Ran MergedByLines(const GitRepository& repository, const Case& one) {
  const TemporaryFolder folder;
  const auto write = [&](const char* name, const std::string& text) {
    return "'" + folder.Write(name, text) + "' ";
  };
  return repository.Git("merge-file -p --diff3 -L ours -L base -L theirs " +
                        write("ours", one.ours) + write("base", one.base) +
                        write("theirs", one.theirs));
}

TEST_CASE("git loses nothing, whichever version is no genotype",
          "[merge][git]") {
  if (!HasGit()) return;
  const GitRepository repository;
  const std::vector<Case> cases = AllCases();
  CommitSides(repository, cases);
  const Ran merge = repository.Git("merge -m merged theirs");
  CHECK(merge.exit == 1);
  CHECK(merge.err.find(".merge_file") == std::string::npos);
  const std::string unmerged =
      repository.Git("-c core.quotePath=off ls-files -u").out;
  int fallbacks = 0;
  for (const Case& one : cases) {
    if (one.is_all_correct || one.ours == one.base || one.theirs == one.base ||
        one.ours == one.theirs)
      continue;  // plsc merges it by what it says, or git alone does
    ++fallbacks;
    INFO(one.file);
    const Ran by_lines = MergedByLines(repository, one);
    CHECK(repository.Read(one.file) == by_lines.out);
    CHECK((unmerged.find("\t" + one.file + "\n") != std::string::npos) ==
          (by_lines.exit != 0));
  }
  CHECK(fallbacks > Sampled(150));
}

TEST_CASE("git diff takes files that are called like options", "[diff][git]") {
  if (!HasGit()) return;
  const GitRepository repository;
  for (const char* name : {"-lead.pls", "--git.pls", "it's a \"$robot\".pls"}) {
    INFO(name);
    repository.Write(name, kHead + "iterations 1\n");
    repository.Commit("base");
    repository.Write(name, kHead + "iterations 2\n");
    const Ran diff = repository.Git("diff");
    CHECK(diff.exit == 0);
    CHECK(diff.err.empty());
    CHECK(diff.out.starts_with(fmt::format("plsc diff a/{0} b/{0}\n", name)));
    CHECK(diff.out.find("+ iterations 2") != std::string::npos);
    repository.Git("checkout -q .");
  }
}

}  // namespace
}  // namespace plsc::test
