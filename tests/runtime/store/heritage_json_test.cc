#include "runtime/store/heritage_json.h"

#include <catch2/catch.hpp>

namespace plsc {

TEST_CASE("Rules count from 1, and senses are typed", "[heritage_json]") {
  Heritage heritage;
  heritage.parents = {3, 5};
  heritage.mutation = Mutation{MutationKind::kSwap, 0};
  heritage.senses = {{"inclined", "False"}};
  const std::vector<State> states = {{"inclined", StateType::kBool, 0, 0, {}}};
  CHECK(HeritageJson(heritage, *PlasticodingAlphabet(), states).dump() ==
        R"({"parents":[3,5],"from_second":[],"mutation":"swap",)"
        R"("mutated_rule":1,"senses":{"inclined":false}})");
  CHECK(HeritageJson({}, *PlasticodingAlphabet(), states).dump() ==
        R"({"parents":[],"from_second":[],"mutation":null,)"
        R"("mutated_rule":null,"senses":{}})");
}

}  // namespace plsc
