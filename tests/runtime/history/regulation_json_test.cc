#include "runtime/history/regulation_json.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/runtime/develop/compile_text.h"

namespace plsc {
namespace {

using Parsed = nlohmann::json;

constexpr const char* kRules =
    "sense wet: bool sense t: real in 0..10 sense ground: { rock, sand, ice }\n"
    "rule X -> if wet = True and ground = ice then { X Y }\n"
    "rule X -> if t >= 5 then { a }\n";

TEST_CASE("An environment as JSON has what each symbol becomes",
          "[regulation]") {
  const Genotype genotype = test::Didactic(kRules);
  CHECK(Parsed::parse(RegulationJson(genotype, {"e", {{1, 6, 2}}})) ==
        Parsed::parse(R"({"genotype": "sample",
          "environment": {"wet": true, "t": 6.0, "ground": "ice"},
          "active_rules": [1, 2],
          "symbols": {"X": {"rules": [1, 2],
                            "joined": [["X", []], ["Y", []], ["a", []]]}}})"));
  CHECK(
      Parsed::parse(RegulationJson(genotype, {"e", {{0, 1, 0}}}))["symbols"] ==
      Parsed::parse(R"({"X": {"rules": []}})"));
}

TEST_CASE("A row as JSON says which values it is for", "[regulation]") {
  const Genotype genotype = test::Didactic(kRules);
  const StateSpace space(genotype);
  REQUIRE(space.size() == 8);
  const Parsed row = Parsed::parse(RegulationRowJson(genotype, space, 2));
  CHECK(row["when"] == Parsed::parse(R"({"wet": [false],
    "t": {"low": 5.0, "high": 10.0, "has_low": true, "has_high": true},
    "ground": ["rock", "sand"]})"));
  CHECK(row["environment"]["ground"] == "rock");
  CHECK(row["active_rules"] == Parsed::parse("[2]"));
  CHECK(row["symbols"] == Parsed::parse(R"({"X": [2]})"));
}

}  // namespace
}  // namespace plsc
