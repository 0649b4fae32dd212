#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

using test::RunPlsc;

TEST_CASE("regulate shows each environment of the file", "[cli][regulate]") {
  const auto ran = RunPlsc({"regulate", "-"}, test::kPlasticText);
  CHECK(ran.exit == 0);
  CHECK(ran.out ==
        "plastic in flat (inclined=False): 1 of 2 rules active\n"
        "C  1  -> C add_front B\n\n"
        "plastic in tilted (inclined=True): 1 of 2 rules active\n"
        "C  2  -> C add_left A2(0.5, 2, 3, 1) move_left add_front B\n\n");
}

TEST_CASE("regulate takes environments", "[cli][regulate]") {
  const auto ran =
      RunPlsc({"regulate", "-", "--env", "inclined=True", "--format", "json"},
              test::kPlasticText);
  CHECK(ran.exit == 0);
  CHECK(nlohmann::json::parse(ran.out)["active_rules"] ==
        nlohmann::json::parse("[2]"));
  CHECK(
      RunPlsc({"regulate", "-", "--env", "nowhere"}, test::kPlasticText).exit ==
      2);
}

TEST_CASE("regulate --table has a row an environment", "[cli][regulate]") {
  const auto ran = RunPlsc({"regulate", "-", "--table"}, test::kPlasticText);
  CHECK(ran.exit == 0);
  CHECK(ran.out ==
        "inclined  C\nFalse     1\nTrue      2\n\n"
        "1: C if inclined = False (line 6)\n"
        "2: C if inclined = True (line 7)\n");
  const auto json = RunPlsc({"regulate", "-", "--table", "--format", "json"},
                            test::kPlasticText);
  CHECK(std::count(json.out.begin(), json.out.end(), '\n') == 2);
  CHECK(
      RunPlsc({"regulate", "-", "--table", "--env", "flat"}, test::kPlasticText)
          .exit == 2);
}

TEST_CASE("regulate refuses a table that nobody could read",
          "[cli][regulate]") {
  std::string text = "plsc 1\nalphabet plasticoding 1\n";
  std::string rules;
  for (int i = 0; i < 17; ++i) {
    const std::string state = "s" + std::to_string(i);
    text += "sense " + state + ": bool\n";
    rules += "rule B -> if " + state + " = True then { B }\n";
  }
  const auto ran = RunPlsc({"regulate", "-", "--table"}, text + rules);
  CHECK(ran.exit == 1);
  CHECK(ran.err.find("65536") != std::string::npos);
}

}  // namespace
}  // namespace plsc
