#include "runtime/history/history_json.h"

#include "tests/runtime/develop/grown.h"

namespace plsc {
namespace {

using Json = nlohmann::ordered_json;

TEST_CASE("a history has its regulation, derivation and events",
          "[history_json]") {
  const auto grown = test::Grow(test::kTwoGenerations, Environment{{0}});
  const Json json = HistoryJson(grown.view());
  REQUIRE(json["regulation"].size() == 4);
  const Json& rule = json["regulation"][1];
  CHECK(rule["rule"] == 2);
  CHECK(rule["head"] == "C");
  CHECK(rule["clause"] == "hot = True");
  CHECK(rule["active"] == false);
  CHECK(rule["terms"][0]["term"] == "hot = True");
  CHECK(rule["terms"][0]["holds"] == false);
  CHECK(rule["terms"][0]["place"]["column"] == 14);
  CHECK(rule["place"]["line"] == 4);
  CHECK(json["regulation"][0]["clause"] == nullptr);
  CHECK(json["regulation"][0]["active"] == true);

  // C / C B / C B add_front A1 mutate_amp
  const Json& derivation = json["derivation"];
  CHECK(derivation["steps"] == Json::parse("[[1],[2,3],[4,5,6,7,8]]"));
  const Json& joint = derivation["symbols"][6];
  CHECK(joint["id"] == 7);
  CHECK(joint["symbol"] == "A1(0.5, 2, 3, 4)");
  CHECK(joint["iteration"] == 2);
  CHECK(joint["rule"] == 3);
  CHECK(joint["position"] == 2);
  CHECK(joint["parent"] == 3);
  CHECK(joint["place"]["file"] == "robot.pls");
  CHECK(joint["place"]["line"] == 5);
  CHECK(derivation["symbols"][0]["parent"] == nullptr);
  CHECK(derivation["symbols"][0]["place"] == nullptr);

  REQUIRE(json["events"].size() == 5);
  const Json& mounted = json["events"][3];
  CHECK(mounted["index"] == 4);
  CHECK(mounted["id"] == 7);
  CHECK(mounted["effect"] == "mounted");
  CHECK(mounted["step"] == "IV");
  CHECK(mounted["expressed"] == true);
  CHECK(mounted["module"] == "2");
  CHECK(mounted["on"] == "1");
  CHECK(mounted["slot"] == "front");
  CHECK(mounted["node"] == "node1");
  CHECK(mounted["partner"] == 3);
  CHECK_FALSE(mounted.contains("edges"));
  const Json& changed = json["events"][4];
  CHECK(changed["before"] == 2.0);
  CHECK(changed["after"] == 3.0);
  CHECK(json["events"][1]["effect"] == "no_slot");
  CHECK(json["events"][1]["expressed"] == false);
}

TEST_CASE("events name their edges", "[history_json]") {
  const auto grown = test::GrowProduction(
      "add_left A1(1,1,1,1) add_right A2(1,1,1,1) add_front T(1) add_edge(1)");
  CHECK(EventJson(grown.view(), 6)["edges"] ==
        Json{"node3-node1", "node3-node2"});
  CHECK(EventJson(grown.view(), 7)["effect"] == "edge_exists");
  CHECK(EventJson(grown.view(), 7)["edges"] == Json{"node3-node2"});
}

TEST_CASE("an ancestry leads to the axiom, with clauses", "[history_json]") {
  const auto grown = test::Grow(test::kTwoGenerations, Environment{{1}});
  // Hot: C B add_left T / C B add_left T add_front A1 mutate_amp add_left T
  const Json ancestry =
      AncestryJson(grown.view(), grown.history.derivation.string()[3]);
  REQUIRE(ancestry.size() == 3);
  CHECK(ancestry[0]["symbol"] == "T(0.5)");
  CHECK(ancestry[0]["clause"] == "hot = True");
  CHECK(ancestry[0]["terms"][0]["holds"] == true);
  CHECK(ancestry[1]["symbol"] == "C");
  CHECK(ancestry[1]["clause"] == nullptr);
  CHECK(ancestry[2]["iteration"] == 0);
  CHECK_FALSE(ancestry[2].contains("clause"));
}

TEST_CASE("a history without bodies has no events", "[history_json]") {
  const auto grown = test::Grow(
      "plsc 1 alphabet d { replaceable X; terminal a } axiom X iterations 1\n"
      "rule X -> { X a }\n",
      Environment{});
  const Json json = HistoryJson(grown.view());
  CHECK_FALSE(json.contains("events"));
  CHECK(json["derivation"]["symbols"].size() == 3);
  CHECK(json["derivation"]["symbols"][0]["place"]["column"] == 55);
}

}  // namespace
}  // namespace plsc
