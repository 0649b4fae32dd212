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
const std::string kShortUsage =
    "plsc 1\ngenotype long\nalphabet plasticoding 1\niterations 1\n"
    "# the body\nrule C -> { C add_left B }  # two\n";

TEST_CASE("trim prints what is left, and its proof", "[cli][trim]") {
  const auto ran = RunPlsc({"trim", "-"}, kLong);
  CHECK(ran.exit == 0);
  CHECK(ran.out == kShortUsage);
  CHECK(ran.err.find("long: 2 of 5 symbols, 1 of 2 rules and 0 of 0 terms of "
                     "clauses left out") != std::string::npos);
  CHECK(ran.err.find("  always: before ") != std::string::npos);
  const auto again = RunPlsc({"trim", "-", "--check"}, kShortUsage);
  CHECK(again.exit == 0);
  CHECK(again.out.empty());
  CHECK(RunPlsc({"trim", "-", "--check"}, kLong).exit == 1);
}

TEST_CASE("trim writes where it is told, and nothing else", "[cli][trim]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("a.pls", kLong);
  CHECK(RunPlsc({"trim", file, "-o", folder / "b.pls"}).exit == 0);
  CHECK(ReadFile(file) == kLong);
  CHECK(ReadFile(folder / "b.pls") == kShortUsage);
  CHECK(RunPlsc({"trim", file, "-o", file}).exit == 1);
  CHECK(RunPlsc({"trim", file, "-o", folder.path().string()}).exit == 1);
  CHECK(RunPlsc({"trim", file, "-o", folder / "no/b.pls"}).exit == 1);
  CHECK(ReadFile(file) == kLong);
  CHECK(RunPlsc({"trim", file, "--write"}).exit == 0);
  CHECK(ReadFile(file) == kShortUsage);
  CHECK(folder.Files() == std::vector<std::string>{"a.pls", "b.pls"});
  CHECK(RunPlsc({"trim", "-", "--write"}, kLong).exit == 2);
  CHECK(RunPlsc({"trim", file, "--write", "-o", "x"}).exit == 2);
}

TEST_CASE("trim looks at the seasons of a scenario only", "[cli][trim]") {
  const std::string text =
      "plsc 1\ngenotype two\nalphabet plasticoding 1\nsense inclined: bool\n"
      "iterations 1\n"
      "rule C -> if inclined = True then { C add_front B }\n"
      "rule C -> if inclined = False then { C add_left B }\n";
  const test::TemporaryFolder folder;
  const auto scenario = [&](const std::string& lines) {
    return folder.Write("s.yaml", "plsc_scenario: 1\n" + lines);
  };
  const std::string flat = "{name: flat, terrain: flat, duration: 1 s}";
  const auto level = RunPlsc(
      {"trim", "-", "--scenario", scenario("seasons: [" + flat + "]\n")}, text);
  CHECK(level.exit == 0);
  CHECK(level.out.find("add_front") == std::string::npos);
  CHECK(level.out.find("rule C -> { C add_left B }") != std::string::npos);
  CHECK(level.err.find("(flat): before ") != std::string::npos);
  CHECK(RunPlsc({"trim", "-"}, text).out == text);
  // Who lives on may come to a place of the hills that feels level, or not.
  const std::string hills =
      "lives: continuous\nseasons:\n  - " + flat +
      "\n  - {name: hills, terrain: rough, duration: 1 s}\n";
  CHECK(RunPlsc({"trim", "-", "--scenario", scenario(hills)}, text).out ==
        text);
  CHECK(RunPlsc({"trim", "-", "--scenario", folder / "none"}, text).exit == 1);
  const auto mute =
      RunPlsc({"trim", "-", "--scenario",
               scenario("sensing: given\nseasons: [" + flat + "]\n")},
              text);
  CHECK(mute.exit == 1);
  CHECK(mute.out.empty());
}

TEST_CASE("trim tells scripts everything", "[cli][trim]") {
  const auto ran = RunPlsc({"trim", "-", "--format", "json"}, kLong);
  CHECK(ran.exit == 0);
  const auto json = nlohmann::json::parse(ran.out);
  CHECK(json["text"] == kShortUsage);
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
