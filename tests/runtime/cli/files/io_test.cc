#include "runtime/cli/files/io.h"

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

TEST_CASE("who goes no further without a source is told", "[io]") {
  const test::TemporaryFolder folder;
  std::istringstream in;
  std::ostringstream out;
  std::ostringstream err;
  cli::Io io{in, out, err};
  CHECK(cli::ReadOrReport(folder.Write("a", "text"), io)->text() == "text");
  CHECK(err.str().empty());
  CHECK_FALSE(cli::ReadOrReport(folder / "no\nne", io));
  CHECK(err.str().starts_with("error[P5014]: cannot read '"));
  CHECK(err.str().find("no\\nne': No such file") != std::string::npos);
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
