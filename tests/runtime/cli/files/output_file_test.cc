#include "runtime/cli/files/output_file.h"

#include <signal.h>
#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <sstream>

#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

namespace fs = std::filesystem;

TEST_CASE("a file is replaced as a whole, or left alone", "[output_file]") {
  const test::TemporaryFolder folder;
  const std::string path = folder / "a";
  REQUIRE_FALSE(cli::WriteFile(path, "one"));
  REQUIRE_FALSE(cli::WriteFile(path, "two"));
  CHECK(test::ReadFile(path) == "two");
  CHECK(folder.Files() == std::vector<std::string>{"a"});
  CHECK(cli::WriteFile(folder / "none/b", "x"));
  CHECK(cli::WriteFile(folder.path().string(), "x"));
  CHECK(folder.Files() == std::vector<std::string>{"a"});
}

TEST_CASE("a full disk leaves the old file and no leftovers", "[output_file]") {
  // A limit on the size of files fails a write as a full disk does.
  const test::TemporaryFolder folder;
  const std::string path = folder.Write("a", "old");
  rlimit before{};
  REQUIRE(::getrlimit(RLIMIT_FSIZE, &before) == 0);
  const rlimit small{1024, before.rlim_max};
  const auto old_handler = ::signal(SIGXFSZ, SIG_IGN);
  REQUIRE(::setrlimit(RLIMIT_FSIZE, &small) == 0);
  const auto failure = cli::WriteFile(path, std::string(4096, 'x'));
  ::setrlimit(RLIMIT_FSIZE, &before);
  ::signal(SIGXFSZ, old_handler);
  CHECK(failure);
  CHECK(test::ReadFile(path) == "old");
  CHECK(folder.Files() == std::vector<std::string>{"a"});
}

TEST_CASE("a file in pieces takes its name and rights when it is finished",
          "[output_file]") {
  const test::TemporaryFolder folder;
  const std::string path = folder.Write("a", "old");
  fs::permissions(path, fs::perms(0640));
  fs::create_symlink("a", folder / "link");
  const std::string piece(100000, 'x');
  {
    cli::OutputFile file(folder / "link");
    CHECK(file.path() == fs::canonical(path));
    CHECK_FALSE(file.Write(piece));
    CHECK_FALSE(file.Write("y"));
    CHECK(test::ReadFile(path) == "old");
    CHECK_FALSE(file.Finish());
  }
  CHECK(test::ReadFile(path) == piece + "y");
  CHECK(fs::status(path).permissions() == fs::perms(0640));
  CHECK(fs::is_symlink(folder / "link"));
  {
    cli::OutputFile file(path);
    CHECK_FALSE(file.Write("half"));
  }
  CHECK(test::ReadFile(path) == piece + "y");
  CHECK(folder.Files() == std::vector<std::string>{"a", "link"});
}

TEST_CASE("why a file is not written is said", "[output_file]") {
  const test::TemporaryFolder folder;
  std::istringstream in;
  std::ostringstream out;
  std::ostringstream err;
  cli::Io io{in, out, err};
  CHECK(cli::WriteOrReport(folder / "a", "x", io));
  CHECK_FALSE(cli::WriteOrReport("/dev/full", "x", io));
  CHECK(err.str() ==
        "error: cannot write '/dev/full': No space left on device\n");
  cli::OutputFile file(folder / "none/b");
  CHECK(file.Write("x") == "No such file or directory");
  CHECK(file.Finish() == "No such file or directory");
}

}  // namespace
}  // namespace plsc
