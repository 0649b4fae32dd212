// Merging with the real git: what the driver promises is what happens.

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include <set>
#include <sstream>

#include "compiler/compile.h"
#include "compiler/print.h"
#include "tests/runtime/merge/git_repository.h"
#include "tests/runtime/merge/mutation_pair.h"

namespace plsc::test {
namespace {

constexpr std::uint64_t kPairs = 400;

std::string FileOf(std::uint64_t pair) {
  return fmt::format("{}.pls", pair);
}

// Both sides of all pairs on two branches, merged at once.
Ran MergePairs(const GitRepository& repository) {
  const auto write = [&](const Genotype MutationPair::*side) {
    for (std::uint64_t i = 0; i < kPairs; ++i)
      repository.Write(FileOf(i), Print(DrawMutationPair(i).*side));
  };
  write(&MutationPair::base);
  repository.Commit("base");
  repository.Git("checkout -q -b theirs");
  write(&MutationPair::theirs);
  repository.Commit("theirs");
  repository.Git("checkout -q main");
  write(&MutationPair::ours);
  repository.Commit("ours");
  return repository.Git("merge -q -m merged theirs");
}

std::set<std::string> Unmerged(const GitRepository& repository) {
  std::istringstream lines(
      repository.Git("diff --name-only --diff-filter=U").out);
  std::set<std::string> names;
  for (std::string name; std::getline(lines, name);)
    if (!name.starts_with("*")) names.insert(name);
  return names;
}

TEST_CASE("Of 400 pairs of mutations git merges all but 1 %, each to both",
          "[merge][git][slow]") {
  if (!HasGit()) return;
  const GitRepository repository;
  MergePairs(repository);
  const std::set<std::string> conflicts = Unmerged(repository);
  CHECK(conflicts.size() <= kPairs / 100);
  const GitRepository by_lines(false);
  MergePairs(by_lines);
  WARN("of " << kPairs << " pairs " << conflicts.size()
             << " conflict, merged by lines " << Unmerged(by_lines).size());
  for (std::uint64_t i = 0; i < kPairs; ++i) {
    INFO("pair " << i);
    const MutationPair pair = DrawMutationPair(i);
    const std::string text = repository.Read(FileOf(i));
    if (conflicts.contains(FileOf(i))) {
      CHECK(text.find("\n<<<<<<< ours\n") != std::string::npos);
      CHECK(!pair.composed);  // nothing else is in conflict
      continue;
    }
    REQUIRE(pair.composed);
    CHECK(text == Print(*pair.composed));
    const auto program = Compile(Source(FileOf(i), text));
    REQUIRE(program);
    CHECK(program->genotype == *pair.composed);
  }
}

TEST_CASE("git's conflict of one rule names file, line and symbol",
          "[merge][git]") {
  if (!HasGit()) return;
  const GitRepository repository;
  const auto commit = [&](const std::string& number) {
    repository.Write("robot.pls",
                     "plsc 1\nalphabet plasticoding 1\nrule C -> {\n  C\n"
                     "  add_front\n  T(" +
                         number + ")\n}\nrule B -> { add_left T(0.5) }\n");
    repository.Commit(number);
  };
  commit("0.5");
  repository.Git("checkout -q -b theirs");
  commit("0.25");
  repository.Git("checkout -q main");
  commit("0.75");
  const Ran merge = repository.Git("merge theirs");
  CHECK(merge.exit == 1);
  CHECK(merge.err.find("robot.pls:3: conflict: rule 1 of C: symbol 3: "
                       "'T(0.5)' is 'T(0.75)' in ours and 'T(0.25)' in "
                       "theirs") != std::string::npos);
  CHECK(repository.Read("robot.pls") ==
        "plsc 1\nalphabet plasticoding 1\n"
        "<<<<<<< ours\nrule C -> {\n  C\n  add_front\n  T(0.75)\n}\n"
        "||||||| base\nrule C -> {\n  C\n  add_front\n  T(0.5)\n}\n"
        "=======\nrule C -> {\n  C\n  add_front\n  T(0.25)\n}\n"
        ">>>>>>> theirs\nrule B -> { add_left T(0.5) }\n");
}

TEST_CASE("git merges a file that both sides added", "[merge][git]") {
  if (!HasGit()) return;
  const GitRepository repository;
  repository.Commit("base");
  repository.Git("checkout -q -b theirs");
  repository.Write("robot.pls", "plsc 1\nalphabet plasticoding 1\nlet a = 1\n");
  repository.Commit("theirs");
  repository.Git("checkout -q main");
  repository.Write("robot.pls", "plsc 1\nalphabet plasticoding 1\nlet b = 2\n");
  repository.Commit("ours");
  CHECK(repository.Git("merge -m both theirs").exit == 0);
  CHECK(repository.Read("robot.pls") ==
        "plsc 1\nalphabet plasticoding 1\nlet a = 1\nlet b = 2\n");
}

TEST_CASE("git diff shows rules and robots", "[diff][git]") {
  if (!HasGit()) return;
  const GitRepository repository;
  const std::string text =
      "plsc 1\ngenotype one\nalphabet plasticoding 1\niterations 1\n"
      "rule C -> {\n  C\n  add_left\n  B\n}\n";
  repository.Write("robot.pls", text);
  repository.Commit("base");
  std::string changed = text;
  changed.replace(changed.find("add_left"), 8, "add_right");
  repository.Write("robot.pls", changed);
  repository.Write("new.pls", text);
  repository.Write("broken.pls", "plsc\n");
  repository.Git("add -A");
  const Ran diff = repository.Git("diff --cached");
  CHECK(diff.exit == 0);
  CHECK(diff.out ==
        "plsc diff a/broken.pls b/broken.pls\n--- a/broken.pls\n"
        "+++ b/broken.pls\n@@ -0,0 +1 @@\n+plsc\n"
        "plsc diff a/new.pls b/new.pls\none: a new genotype\n"
        "plsc diff a/robot.pls b/robot.pls\n~ rule 1 of C (line 5)\n"
        "      C\n    ~ add_left -> add_right\n      B\n"
        "one in any:\n    > module 2 (B): x=-1,y=0 -> x=1,y=0\n"
        "    ~ facing of module 2 (B at x=-1,y=0): left -> right\n");
  repository.Git("commit -q -m changed");
  repository.Git("mv robot.pls renamed.pls");
  CHECK(repository.Git("diff --cached -M").exit == 0);
  repository.Git("rm -q -f new.pls");
  CHECK(repository.Git("diff --cached new.pls").out.empty());
  CHECK(repository.Git("diff --cached HEAD -- new.pls").out ==
        "plsc diff a/new.pls b/new.pls\none: the genotype is gone\n");
}

}  // namespace
}  // namespace plsc::test
