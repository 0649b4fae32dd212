#include <catch2/catch.hpp>
#include <filesystem>

#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

using test::RunPlsc;

const std::string kHead = "plsc 1\nalphabet plasticoding 1\n";
const std::string kWrong = kHead + "rule B -> { add_lef, T(+0.5) }\n";
const std::string kRight = kHead + "rule B -> { add_left T(0.5) }\n";
const std::string kHopeless = kHead + "rule B -> { add_lef wheel }\n";

TEST_CASE("fix mends a file and says what it did", "[fix]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("a.pls", kWrong);
  const auto ran = RunPlsc({"fix", file});
  CHECK(ran.exit == 0);
  CHECK(ran.out.empty());
  CHECK(test::ReadFile(file) == kRight);
  CHECK(ran.err.find(file + ":3:20: fixed [P1116]: removed ','\n") !=
        std::string::npos);
  CHECK(ran.err.find("fixed [P2001]: 'add_lef' -> 'add_left'\n") !=
        std::string::npos);
  CHECK(ran.err.find("fixed [P1110]: '+0.5' -> '0.5'\n") != std::string::npos);
  CHECK(folder.Files() == std::vector<std::string>{"a.pls"});
}

TEST_CASE("fix leaves a right file untouched", "[fix]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("a.pls", kRight);
  const auto before = std::filesystem::last_write_time(file);
  const auto ran = RunPlsc({"fix", file});
  CHECK(ran.exit == 0);
  CHECK(ran.err.empty());
  CHECK(std::filesystem::last_write_time(file) == before);
}

TEST_CASE("fix shows the errors that remain", "[fix]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("a.pls", kHopeless);
  const auto ran = RunPlsc({"fix", file});
  CHECK(ran.exit == 1);
  CHECK(test::ReadFile(file) == kHead + "rule B -> { add_left wheel }\n");
  CHECK(ran.err.find("error[P2001]: unknown symbol 'wheel'") !=
        std::string::npos);
  CHECK(ran.err.find("3 | rule B -> { add_left wheel }") != std::string::npos);
}

TEST_CASE("fix --check writes nothing and tells", "[fix]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("a.pls", kWrong);
  const auto ran = RunPlsc({"fix", "--check", file});
  CHECK(ran.exit == 1);
  CHECK(test::ReadFile(file) == kWrong);
  CHECK(ran.err.find("would fix [P1116]") != std::string::npos);
  const auto hopeless = RunPlsc({"fix", "--check", "-"}, kHopeless);
  CHECK(hopeless.exit == 1);
  CHECK(hopeless.out.empty());
  CHECK(hopeless.err.find("--> <stdin> (mended):3:22\n") != std::string::npos);
  CHECK(RunPlsc({"fix", "--check", folder.Write("b.pls", kRight)}).exit == 0);
}

TEST_CASE("fix --diff prints what would change and writes nothing", "[fix]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("a.pls", kWrong);
  const auto ran = RunPlsc({"fix", "--diff", file});
  CHECK(ran.exit == 1);
  CHECK(test::ReadFile(file) == kWrong);
  CHECK(ran.out == "--- " + file + "\n+++ " + file +
                       " (mended)\n@@ -1,3 +1,3 @@\n plsc 1\n alphabet "
                       "plasticoding 1\n-rule B -> { add_lef, T(+0.5) "
                       "}\n+rule B -> { add_left T(0.5) }\n");
  CHECK(ran.err.find("would fix [P1116]") != std::string::npos);
  const auto right = RunPlsc({"fix", "--diff", "-"}, kRight);
  CHECK(right.exit == 0);
  CHECK(right.out.empty());
  // Nothing would change, and yet the input is wrong.
  const auto hopeless =
      RunPlsc({"fix", "--diff", "-"}, kHead + "rule wheel -> { B }\n");
  CHECK(hopeless.exit == 1);
  CHECK(hopeless.out.empty());
  CHECK(RunPlsc({"fix", "--diff", "--check", "-"}, kRight).exit == 2);
}

TEST_CASE("fix of standard input prints the text", "[fix]") {
  const auto mended = RunPlsc({"fix", "-"}, kWrong);
  CHECK(mended.exit == 0);
  CHECK(mended.out == kRight);
  const auto right = RunPlsc({"fix", "-"}, kRight);
  CHECK(right.out == kRight);
  CHECK(right.err.empty());
  const auto hopeless = RunPlsc({"fix", "-"}, kHead + "rule wheel -> { B }\n");
  CHECK(hopeless.exit == 1);
  CHECK(hopeless.out == kHead + "rule wheel -> { B }\n");
}

TEST_CASE("fix shows line ends of what it inserts", "[fix]") {
  const auto ran = RunPlsc({"fix", "-"}, "alphabet plasticoding 1\n");
  CHECK(ran.exit == 0);
  CHECK(ran.out == kHead);
  CHECK(ran.err == "<stdin>:1:1: fixed [P5001]: inserted 'plsc 1\\n'\n");
}

TEST_CASE("fix goes on after a file that it cannot read", "[fix]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("a.pls", kWrong);
  const auto ran = RunPlsc({"fix", folder / "none.pls", file});
  CHECK(ran.exit == 1);
  CHECK(ran.err.find("error[P5014]") != std::string::npos);
  CHECK(test::ReadFile(file) == kRight);
}

}  // namespace
}  // namespace plsc
