#include "runtime/cli/testing/files.h"

#include <catch2/catch.hpp>
#include <filesystem>

#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> Genotypes(const cli::FoundTests& found) {
  std::vector<std::string> names;
  for (const cli::TestPaths& paths : found.tests)
    names.push_back(fs::path(paths.genotype).filename().string());
  return names;
}

TEST_CASE("a golden file is named after its genotype", "[test_files]") {
  const auto found =
      cli::FindTests({"a/x.pls", "a/y.golden.json", "a/z.txt", "w"});
  CHECK(found.tests ==
        std::vector<cli::TestPaths>{{"a/x.pls", "a/x.golden.json"},
                                    {"a/y.pls", "a/y.golden.json"},
                                    {"a/z.txt", "a/z.txt.golden.json"},
                                    {"w", "w.golden.json"}});
}

TEST_CASE("every test is found once, however it is named", "[test_files]") {
  const test::TemporaryFolder folder;
  const std::string path = folder.Write("x.pls", "");
  const std::string golden = folder.Write("x.golden.json", "");
  const auto found = cli::FindTests({path, golden, folder.path().string(),
                                     folder.path().string() + "/./x.pls"});
  CHECK(found.tests.size() == 1);
  CHECK(found.problems.empty());
}

TEST_CASE("folders are searched in order, without what is hidden",
          "[test_files]") {
  const test::TemporaryFolder folder;
  fs::create_directories(folder.path() / "b" / "deep");
  fs::create_directories(folder.path() / ".git");
  fs::create_directories(folder.path() / "folder.pls");
  fs::create_directory_symlink(folder.path(), folder.path() / "b" / "loop");
  for (const char* name : {"c.pls", "a.pls", "b/deep/d.golden.json",
                           ".git/e.pls", ".f.pls", "g.yaml", "a.golden.json"})
    folder.Write(name, "");
  const auto found = cli::FindTests({folder.path().string()});
  CHECK(Genotypes(found) ==
        std::vector<std::string>{"a.pls", "d.pls", "c.pls"});
  CHECK(found.problems.empty());
}

TEST_CASE("a folder without tests is a problem", "[test_files]") {
  const test::TemporaryFolder folder;
  const auto found = cli::FindTests({folder.path().string()});
  CHECK(found.tests.empty());
  REQUIRE(found.problems.size() == 1);
  CHECK(found.problems[0].paths.genotype == folder.path().string());
  CHECK(found.problems[0].cases[0].verdict == cli::Verdict::kError);
}

}  // namespace
}  // namespace plsc
