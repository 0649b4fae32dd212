#include "runtime/develop/phenotype_json.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "runtime/develop/develop.h"
#include "tests/runtime/develop/compile_text.h"

namespace plsc {
namespace {

using nlohmann::json;

TEST_CASE("a robot's JSON tells what grew and from which rules",
          "[phenotype_json]") {
  const Genotype genotype = test::Robot(
      "sense wet: bool\nsense heat: real in 0..1\nsense ground: { sand, rock "
      "}\n"
      "iterations 1\n"
      "rule C -> if wet = False then { C }\n"
      "rule C -> { C add_front T(0.25) move_ref_I(1, 2) }\n");
  const Environment environment{{1, 0.5, 1}};
  const ActiveRules active = Regulate(genotype, environment);
  const SymbolString string = *Derive(genotype, active);
  const Phenotype phenotype = Develop(genotype, string);
  const json robot =
      json::parse(DevelopmentJson(genotype, environment, string, &phenotype));
  CHECK(robot["environment"] ==
        json::parse(R"({"wet": true, "heat": 0.5, "ground": "rock"})"));
  CHECK(robot["active_rules"] == json{2});
  CHECK(robot["early"] ==
        json::parse(R"([["C", []], ["add_front", []], ["T", [0.25]],
                        ["move_ref_I", [1, 2]]])"));
  CHECK(robot["early"][3][1][0].is_number_integer());
  CHECK(robot["body"]["children"]["front"] ==
        json::parse(R"({"id": "1s1", "type": "T", "angle": 0, "x": null,
                        "y": null, "facing": null, "children": {}})"));
  CHECK(robot["brain"]["imu_inputs"] == 6);
  CHECK(json::parse(BodyJson(phenotype.body)) == robot["body"]);
  CHECK(json::parse(BrainJson(phenotype)) == robot["brain"]);
}

TEST_CASE("a string without a body has no body keys", "[phenotype_json]") {
  const Genotype genotype = test::Didactic("iterations 1\nrule X -> { Y a }\n");
  const SymbolString string = *Derive(genotype, Regulate(genotype, {}));
  const json derived =
      json::parse(DevelopmentJson(genotype, {}, string, nullptr));
  CHECK(derived["early"] == json::parse(R"([["Y", []], ["a", []]])"));
  CHECK_FALSE(derived.contains("body"));
  CHECK_FALSE(derived.contains("brain_descriptors"));
}

}  // namespace
}  // namespace plsc
