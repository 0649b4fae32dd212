#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>

#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

using test::ReadFile;
using test::RunPlsc;

constexpr const char* kUntidy =
    "plsc 1\n# why\nrule C->{C add_front B} # body\n"
    "alphabet plasticoding 1\ngenotype tidy\n";

TEST_CASE("fmt rewrites a file and keeps its comments", "[fmt]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("a.pls", kUntidy);
  ::chmod(file.c_str(), 0640);
  REQUIRE(RunPlsc({"fmt", file}).exit == 0);
  const std::string text = ReadFile(file);
  CHECK(text != kUntidy);
  CHECK(text.find("# why") != std::string::npos);
  CHECK(text.find("# body") != std::string::npos);
  CHECK(text.find("  add_front\n  B\n") != std::string::npos);
  struct stat status {};
  REQUIRE(::stat(file.c_str(), &status) == 0);
  CHECK((status.st_mode & 0777) == 0640);
  CHECK(folder.Files() == std::vector<std::string>{"a.pls"});
  SECTION("again it changes nothing") {
    CHECK(RunPlsc({"fmt", "--check", file}).exit == 0);
    REQUIRE(RunPlsc({"fmt", file}).exit == 0);
    CHECK(ReadFile(file) == text);
  }
}

TEST_CASE("fmt --check names what would change and writes nothing", "[fmt]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("a.pls", kUntidy);
  const auto ran = RunPlsc({"fmt", "--check", file});
  CHECK(ran.exit == 1);
  CHECK(ran.out == file + "\n");
  CHECK(ReadFile(file) == kUntidy);
}

TEST_CASE("fmt --diff shows what would change and writes nothing", "[fmt]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("a.pls", kUntidy);
  const auto ran = RunPlsc({"fmt", "--diff", file});
  CHECK(ran.exit == 1);
  CHECK(ran.out.starts_with("--- " + file + "\n+++ " + file +
                            " (formatted)\n@@ -1,"));
  CHECK(ran.out.find("\n+  add_front\n") != std::string::npos);
  CHECK(ReadFile(file) == kUntidy);
  REQUIRE(RunPlsc({"fmt", file}).exit == 0);
  const auto again = RunPlsc({"fmt", "--diff", file});
  CHECK(again.exit == 0);
  CHECK(again.out.empty());
  CHECK(RunPlsc({"fmt", "--diff", "--check", file}).exit == 2);
}

TEST_CASE("fmt prints what it reads from standard input", "[fmt]") {
  const auto ran = RunPlsc({"fmt", "-"}, kUntidy);
  CHECK(ran.exit == 0);
  CHECK(ran.out.substr(0, 6) == "plsc 1");
  const auto again = RunPlsc({"fmt", "-"}, ran.out);
  CHECK(again.out == ran.out);
}

TEST_CASE("fmt leaves a wrong file alone", "[fmt]") {
  const test::TemporaryFolder folder;
  const std::string text = "plsc 1\nrule C -> { C\n";
  const std::string file = folder.Write("a.pls", text);
  const auto ran = RunPlsc({"fmt", file});
  CHECK(ran.exit == 1);
  CHECK(ran.err.find("not formatted") != std::string::npos);
  CHECK(ReadFile(file) == text);
}

TEST_CASE("fmt goes on after a file that is wrong", "[fmt]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("a.pls", kUntidy);
  CHECK(RunPlsc({"fmt", folder / "none.pls", file}).exit == 1);
  CHECK(ReadFile(file) != kUntidy);
}

TEST_CASE("fmt follows a symbolic link to the file", "[fmt]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("a.pls", kUntidy);
  REQUIRE(::symlink(file.c_str(), (folder / "link.pls").c_str()) == 0);
  REQUIRE(RunPlsc({"fmt", folder / "link.pls"}).exit == 0);
  CHECK(std::filesystem::is_symlink(folder / "link.pls"));
  CHECK(ReadFile(file) != kUntidy);
}

}  // namespace
}  // namespace plsc
