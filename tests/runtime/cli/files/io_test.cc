#include "runtime/cli/files/io.h"

#include <signal.h>
#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <sstream>

#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

Result<Source> Read(const std::string& path, const std::string& in = "") {
  std::istringstream input(in);
  std::ostringstream out;
  std::ostringstream err;
  cli::Io io{input, out, err};
  return cli::ReadSource(path, io);
}

TEST_CASE("a source is a file or standard input", "[io]") {
  const test::TemporaryFolder folder;
  const std::string path = folder.Write("a", std::string("x\0y", 3));
  const auto file = Read(path);
  REQUIRE(file);
  CHECK(file->name() == path);
  CHECK(file->text() == std::string_view("x\0y", 3));
  const auto in = Read("-", "text");
  REQUIRE(in);
  CHECK(in->name() == "<stdin>");
  CHECK(in->text() == "text");
}

TEST_CASE("what cannot be read is said", "[io]") {
  const test::TemporaryFolder folder;
  const auto missing = Read(folder / "none");
  REQUIRE_FALSE(missing);
  CHECK(missing.diagnostics()[0].code == Code::kUnreadableFile);
  CHECK(missing.diagnostics()[0].message.find("No such file") !=
        std::string::npos);
  CHECK(Read(folder.path().string()).diagnostics()[0].code ==
        Code::kUnreadableFile);
  const std::string huge((16u << 20) + 1, ' ');
  CHECK(Read(folder.Write("huge", huge)).diagnostics()[0].code ==
        Code::kTooLargeFile);
  CHECK(Read("-", huge).diagnostics()[0].code == Code::kTooLargeFile);
}

TEST_CASE("a file is replaced as a whole, or left alone", "[io]") {
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

TEST_CASE("a full disk leaves the old file and no leftovers", "[io]") {
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

TEST_CASE("Colour is for terminals whose user does not refuse it", "[io]") {
  CHECK(cli::WantsColor(true, nullptr));
  CHECK(cli::WantsColor(true, ""));
  CHECK_FALSE(cli::WantsColor(true, "1"));
  CHECK_FALSE(cli::WantsColor(true, "0"));
  CHECK_FALSE(cli::WantsColor(false, nullptr));
}

}  // namespace
}  // namespace plsc
