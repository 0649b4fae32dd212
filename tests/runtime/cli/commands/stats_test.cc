#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

using test::RunPlsc;

TEST_CASE("stats counts in the file's environments", "[cli][stats]") {
  const auto ran = RunPlsc({"stats", "-"}, test::kPlasticText);
  CHECK(ran.exit == 0);
  CHECK(ran.out.find("flat") != std::string::npos);
  CHECK(ran.out.find("2 bodies, 2 brains") != std::string::npos);
  const auto one =
      RunPlsc({"stats", "-", "--env", "tilted"}, test::kPlasticText);
  CHECK(one.out.find("flat") == std::string::npos);
  CHECK(RunPlsc({"stats", "-", "--env", "wet"}, test::kPlasticText).exit == 2);
}

TEST_CASE("stats of a file without environments looks at all", "[cli][stats]") {
  const auto ran = RunPlsc({"stats", "-", "--format", "json"},
                           "plsc 1\nalphabet plasticoding 1\n"
                           "sense a: bool\nsense b: bool\n"
                           "rule C -> if a = True or b = True then { C }\n");
  CHECK(ran.exit == 0);
  const auto json = nlohmann::json::parse(ran.out);
  REQUIRE(json["environments"].size() == 2);
  CHECK(json["environments"][0]["environment"] == "a = False and b = False");
}

TEST_CASE("stats of several files is a line a genotype", "[cli][stats]") {
  const test::TemporaryFolder folder;
  const std::string zoo = folder.Write(
      "zoo.pls",
      "plsc 1\nalphabet plasticoding 1\n"
      "genotype a\nrule C -> { C B }\ngenotype b\nrule C -> { C }\n");
  const std::string one = folder.Write("one.pls", test::kPlasticText);
  const auto ran = RunPlsc({"stats", zoo, one, "--format", "json"});
  CHECK(ran.exit == 0);
  CHECK(std::count(ran.out.begin(), ran.out.end(), '\n') == 3);
  CHECK(ran.out.find(zoo + "#b") != std::string::npos);
  const auto some = RunPlsc({"stats", zoo + "#a", folder / "none.pls", one});
  CHECK(some.exit == 1);
  CHECK(some.out.find("plastic: 2 rules") != std::string::npos);
}

TEST_CASE("stats says where a robot outgrows its limit", "[cli][stats]") {
  const auto ran = RunPlsc({"stats", "-"},
                           "plsc 1\nalphabet plasticoding 1\niterations 30\n"
                           "rule C -> { C B }\nrule B -> { B B }\n");
  CHECK(ran.exit == 1);
  CHECK(ran.out.empty());
  CHECK(ran.err.find("P4001") != std::string::npos);
  CHECK(RunPlsc({"stats", "-"}, "").exit == 1);
  CHECK(RunPlsc({"stats"}).exit == 2);
}

}  // namespace
}  // namespace plsc
