#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

using test::ReadFile;
using test::RunPlsc;

const std::string kLong =
    "plsc 1\ngenotype long\nalphabet plasticoding 1\niterations 1\n"
    "# the body\nrule C -> { C B add_left B }  # two\n"
    "rule T -> { T(1) }\n";
const std::string kShort =
    "plsc 1\ngenotype long\nalphabet plasticoding 1\niterations 1\n"
    "# the body\nrule C -> { C add_left B }  # two\n";

TEST_CASE("trim prints what is left, and its proof", "[cli][trim]") {
  const auto ran = RunPlsc({"trim", "-"}, kLong);
  CHECK(ran.exit == 0);
  CHECK(ran.out == kShort);
  CHECK(ran.err.find("long: 2 of 5 symbols, 1 of 2 rules and 0 of 0 terms of "
                     "clauses left out") != std::string::npos);
  CHECK(ran.err.find("  always: before ") != std::string::npos);
  const auto again = RunPlsc({"trim", "-", "--check"}, kShort);
  CHECK(again.exit == 0);
  CHECK(again.out.empty());
  CHECK(RunPlsc({"trim", "-", "--check"}, kLong).exit == 1);
}

TEST_CASE("trim writes where it is told, and nothing else", "[cli][trim]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("a.pls", kLong);
  CHECK(RunPlsc({"trim", file, "-o", folder / "b.pls"}).exit == 0);
  CHECK(ReadFile(file) == kLong);
  CHECK(ReadFile(folder / "b.pls") == kShort);
  CHECK(RunPlsc({"trim", file, "-o", file}).exit == 1);
  CHECK(RunPlsc({"trim", file, "-o", folder.path().string()}).exit == 1);
  CHECK(RunPlsc({"trim", file, "-o", folder / "no/b.pls"}).exit == 1);
  CHECK(ReadFile(file) == kLong);
  CHECK(RunPlsc({"trim", file, "--write"}).exit == 0);
  CHECK(ReadFile(file) == kShort);
  CHECK(folder.Files() == std::vector<std::string>{"a.pls", "b.pls"});
  CHECK(RunPlsc({"trim", "-", "--write"}, kLong).exit == 2);
  CHECK(RunPlsc({"trim", file, "--write", "-o", "x"}).exit == 2);
}

TEST_CASE("trim tells scripts everything", "[cli][trim]") {
  const auto ran = RunPlsc({"trim", "-", "--format", "json"}, kLong);
  CHECK(ran.exit == 0);
  const auto json = nlohmann::json::parse(ran.out);
  CHECK(json["text"] == kShort);
  CHECK(json["complete"] == true);
  const auto& one = json["genotypes"][0];
  CHECK(one["before"]["symbols"] == 5);
  CHECK(one["after"]["symbols"] == 3);
  CHECK(one["proof"].size() == 1);
  CHECK(one["proof"][0]["before"] == one["proof"][0]["after"]);
  CHECK(one["proof"][0]["before"].get<std::string>().size() == 32);
}

TEST_CASE("trim takes one of several genotypes", "[cli][trim]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write(
      "zoo.pls",
      "plsc 1\nalphabet plasticoding 1\niterations 1\n"
      "genotype a\nrule C -> { C B }\ngenotype b\nrule C -> { C B }\n");
  const auto ran = RunPlsc({"trim", file + "#b"});
  CHECK(ran.exit == 0);
  CHECK(ran.out ==
        "plsc 1\nalphabet plasticoding 1\niterations 1\n"
        "genotype a\nrule C -> { C B }\ngenotype b\n");
  CHECK(RunPlsc({"trim", file + "#c"}).exit == 1);
}

TEST_CASE("trim changes nothing where it cannot prove anything",
          "[cli][trim]") {
  const test::TemporaryFolder folder;
  const std::string grows =
      "plsc 1\nalphabet plasticoding 1\nsense hot: bool\niterations 30\n"
      "rule C -> { C B }\nrule B -> if hot = True then { B B }\n";
  const std::string file = folder.Write("grows.pls", grows);
  const auto ran = RunPlsc({"trim", file, "--write"});
  CHECK(ran.exit == 1);
  CHECK(ran.err.find("error[P4001]: in an environment with hot = True,") !=
        std::string::npos);
  CHECK(ReadFile(file) == grows);
  CHECK(RunPlsc({"trim", "-"}, "").exit == 1);
  CHECK(RunPlsc({"trim", "-"}, std::string("\0\1\2", 3)).exit == 1);
  CHECK(RunPlsc({"trim", "-"}, "plsc 1\nrule C -> {").exit == 1);
  CHECK(RunPlsc({"trim", folder / "none.pls"}).exit == 1);
  CHECK(RunPlsc({"trim", folder.path().string()}).exit == 1);
}

}  // namespace
}  // namespace plsc
