#include "runtime/history/provenance_json.h"

#include "tests/runtime/develop/grown.h"

namespace plsc {
namespace {

using Json = nlohmann::ordered_json;

TEST_CASE("a part's origin and changes carry their ancestry",
          "[provenance_json]") {
  const auto grown = test::Grow(test::kTwoGenerations, Environment{{0}});
  const PhenotypePart part{PartKind::kNode, "1"};
  const Json json =
      PartJson(grown.view(), part, HistoryOf(grown.trace(), part));
  CHECK(json["node"] == "node1");
  CHECK(json["origin"]["symbol"] == "A1(0.5, 2, 3, 4)");
  CHECK(json["origin"]["ancestry"].size() == 3);
  REQUIRE(json["changes"].size() == 1);
  CHECK(json["changes"][0]["effect"] == "neuron_changed");
  CHECK(json["changes"][0]["ancestry"][0]["place"]["column"] == 40);
}

TEST_CASE("a part that is not there has no origin", "[provenance_json]") {
  const auto grown = test::Grow(test::kTwoGenerations, Environment{{0}});
  const Json json =
      PartJson(grown.view(), {PartKind::kEdge, "1-2"}, std::nullopt);
  CHECK(json["edge"] == "1-2");
  CHECK(json["origin"] == nullptr);
  CHECK(json["changes"].empty());
}

TEST_CASE("a symbol's occurrences are listed, replaced or not",
          "[provenance_json]") {
  const auto grown = test::Grow(test::kTwoGenerations, Environment{{0}});
  const Json json = FatesJson(grown.view(), {0, 1});
  CHECK(json["symbol"] == "B");
  CHECK(json["place"]["line"] == 3);
  CHECK(json["rule"]["active"] == true);
  REQUIRE(json["occurrences"].size() == 2);
  CHECK(json["occurrences"][0]["replaced_in"] == 2);
  CHECK(json["occurrences"][0]["event"] == nullptr);
  CHECK(json["occurrences"][1]["replaced_in"] == nullptr);
  CHECK(json["occurrences"][1]["index"] == 2);
  CHECK(json["occurrences"][1]["event"]["effect"] == "no_slot");
}

}  // namespace
}  // namespace plsc
