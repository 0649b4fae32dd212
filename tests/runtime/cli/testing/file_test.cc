#include "runtime/cli/testing/file.h"

#include <catch2/catch.hpp>

#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

using cli::TestOutcome;
using cli::Verdict;

std::string Skeleton(const std::string& environments) {
  return "{\"plsc_golden\": 1, \"environments\": [" + environments + "]}";
}

struct Pair {
  test::TemporaryFolder folder;
  cli::TestPaths paths{folder / "g.pls", folder / "g.golden.json"};
};

TEST_CASE("TestFile records nothing but when asked", "[test_file]") {
  const Pair pair;
  pair.folder.Write("g.pls", test::kPlasticText);
  const TestOutcome plain = cli::TestFile(pair.paths, false);
  REQUIRE(plain.tested.cases.size() == 1);
  CHECK(plain.tested.cases[0].verdict == Verdict::kUnrecorded);
  CHECK(!plain.new_golden);

  const TestOutcome update = cli::TestFile(pair.paths, true);
  REQUIRE(update.tested.cases.size() == 2);
  CHECK(update.tested.cases[0].environment == "flat");
  CHECK(update.tested.cases[1].verdict == Verdict::kUpdated);
  REQUIRE(update.new_golden);
  CHECK(pair.folder.Files() == std::vector<std::string>{"g.pls"});

  pair.folder.Write("g.golden.json", *update.new_golden);
  for (const bool again : {false, true}) {
    const TestOutcome same = cli::TestFile(pair.paths, again);
    CHECK(same.tested.cases[0].verdict == Verdict::kSame);
    CHECK(same.tested.cases[1].verdict == Verdict::kSame);
    CHECK(!same.new_golden);
  }
}

TEST_CASE("an update keeps tolerance, order and hand-written environments",
          "[test_file]") {
  const Pair pair;
  pair.folder.Write("g.pls", test::kPlasticText);
  pair.folder.Write("g.golden.json",
                    "{\"plsc_golden\": 1, \"descriptor_tolerance\": 0.5, "
                    "\"environments\": [{\"environment\": "
                    "\"inclined=True,hot=False\"}, {\"environment\": "
                    "\"tilted\"}]}");
  const TestOutcome before = cli::TestFile(pair.paths, false);
  REQUIRE(before.tested.cases.size() == 3);
  CHECK(before.tested.cases[2].environment == "flat");
  for (const cli::TestCase& test : before.tested.cases)
    CHECK(test.verdict == Verdict::kUnrecorded);
  const TestOutcome update = cli::TestFile(pair.paths, true);
  REQUIRE(update.new_golden);
  CHECK(update.new_golden->find("\"descriptor_tolerance\": 0.5,") !=
        std::string::npos);
  const auto hand = update.new_golden->find("inclined=True,hot=False");
  CHECK(hand < update.new_golden->find("\"tilted\""));
  CHECK(update.new_golden->find("\"tilted\"") <
        update.new_golden->find("\"flat\""));
}

TEST_CASE("what cannot be tested is said and not updated", "[test_file]") {
  struct Row {
    const char* why;
    std::string genotype;  ///< empty: none
    std::string golden;    ///< empty: none
    const char* message;
  };
  const std::string plastic = test::kPlasticText;
  const std::string no_names =
      plastic.substr(0, plastic.find("environment flat"));
  const std::string real =
      "plsc 1\ngenotype g\nalphabet plasticoding 1\n"
      "sense t: real in 0..1\nrule C -> { C }\n";
  const std::vector<Row> rows = {
      {"no genotype", "", Skeleton("{\"environment\": \"a\"}"),
       "there is no genotype"},
      {"neither", "", "", "cannot read"},
      {"does not compile", "plsc 1\nrule", "", "error[P"},
      {"broken golden file", plastic, "{", "error[P5100]: not JSON"},
      {"unknown name", plastic, Skeleton("{\"environment\": \"slope\"}"),
       "no environment 'slope' (it names: flat tilted)"},
      {"a state is missing", plastic,
       Skeleton("{\"environment\": \"hot=True\"}"),
       "no value for state 'inclined'"},
      {"a wrong value", plastic, Skeleton("{\"environment\": \"inclined=2\"}"),
       "expected True or False"},
      {"too many environments", real, "", "which environments?"},
      {"nothing named", no_names, Skeleton("{\"environment\": \"flat\"}"),
       "(it names: none)"},
      {"too long",
       "plsc 1\ngenotype g\nalphabet a { replaceable X }\naxiom X\n"
       "iterations 100\nrule X -> { X X }\n",
       "", "error[P4001]"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const Pair pair;
      if (!row.genotype.empty()) pair.folder.Write("g.pls", row.genotype);
      if (!row.golden.empty()) pair.folder.Write("g.golden.json", row.golden);
      const TestOutcome outcome = cli::TestFile(pair.paths, true);
      CHECK(!outcome.new_golden);
      REQUIRE(!outcome.tested.cases.empty());
      INFO(outcome.tested.cases[0].message);
      CHECK(outcome.tested.cases[0].verdict == Verdict::kError);
      CHECK(outcome.tested.cases[0].message.find(row.message) !=
            std::string::npos);
      CHECK(outcome.tested.cases[0].message.ends_with("\n"));
      for (const cli::TestCase& test : outcome.tested.cases)
        CHECK(test.verdict == Verdict::kError);
    }
  }
}

TEST_CASE("a changed genotype differs where it changed", "[test_file]") {
  const Pair pair;
  std::string text = test::kPlasticText;
  pair.folder.Write("g.pls", text);
  pair.folder.Write("g.golden.json",
                    *cli::TestFile(pair.paths, true).new_golden);
  text.replace(text.find("A2(0.5, 2.0"), 11, "A2(0.5, 4.0");
  pair.folder.Write("g.pls", text);
  const TestOutcome outcome = cli::TestFile(pair.paths, false);
  REQUIRE(outcome.tested.cases.size() == 2);
  CHECK(outcome.tested.cases[0].verdict == Verdict::kSame);
  CHECK(outcome.tested.cases[1].verdict == Verdict::kDiffers);
  REQUIRE(outcome.tested.cases[1].differences.size() >= 2);
  CHECK(Describe(outcome.tested.cases[1].differences[1]) ==
        "amplitude of node1 (A2 at x=-1,y=0): expected 2, found 4");
}

}  // namespace
}  // namespace plsc
