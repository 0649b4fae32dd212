#include "runtime/compare/difference_json.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace plsc {
namespace {

TEST_CASE("Differences are JSON with what changed only", "[difference_json]") {
  ItemChange change{ItemChangeKind::kChanged,
                    "rule 1 of B",
                    3,
                    4,
                    "rule B -> {",
                    "rule B -> {",
                    {}};
  const PartContent part{"T", {"1"}};
  change.parts = {{part, part}, {part, std::nullopt}};
  GenotypeDifference robots;
  robots.genotype = "one";
  robots.environments.push_back(
      {{"a=True", {"tilted"}, {}, {}},
       {{DifferenceKind::kChanged, "weight", "1", "2"}}});
  const auto json =
      nlohmann::json::parse(DifferenceJson({{"one", {change}}}, {robots}));
  const char* const expected = R"json({
    "differs": true,
    "texts": [{"genotype": "one", "changes": [{
      "item": "rule 1 of B", "change": "changed", "old_line": 3,
      "new_line": 4, "old": "rule B -> {", "new": "rule B -> {",
      "parts": [{"old": "T(1)",
                    "new" : null
}]
}]
}],
    "robots": [{"genotype": "one", "change": "changed", "differs": true,
      "limitation": "", "environments": [{
        "environment": "a=True", "names": ["tilted"], "differences": [{
          "kind": "changed", "what": "weight", "old": "1", "new": "2"}]}]}]
})json";
  CHECK(json == nlohmann::json::parse(expected));
}

TEST_CASE("A new genotype is a difference, an equal one is none",
          "[difference_json]") {
  GenotypeDifference same;
  same.environments.push_back({{"any", {}, {}, {}}, {}});
  CHECK_FALSE(same.is_different());
  GenotypeDifference added;
  added.kind = ItemChangeKind::kAdded;
  CHECK(added.is_different());
  CHECK(nlohmann::json::parse(DifferenceJson({}, {same}))["differs"] == false);
}

}  // namespace
}  // namespace plsc
