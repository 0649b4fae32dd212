#include "compiler/changes/rule_shape.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

TEST_CASE("A rule is known again by its clause or by its symbols",
          "[rule_shape]") {
  const RuleShape rule{1, {10, 11, 12, 13}, {20, 21, 22, 23}};
  RuleShape shorter = rule;
  shorter.symbols.pop_back();
  shorter.names.pop_back();
  RuleShape other_clause = rule;
  other_clause.clause = 2;
  const RuleShape other_body{1, {30, 31}, {40, 41}};
  const RuleShape other{2, {30, 31}, {40, 41}};
  RuleShape other_arguments = rule;
  other_arguments.symbols = {50, 51, 52, 53};
  const std::vector<RuleShape> from{rule};
  const std::vector<RuleShape> to{rule,       shorter, other_clause,
                                  other_body, other,   other_arguments};
  const EditCosts costs = CostsOfRules(from, to);
  CHECK(costs.replace(0, 0) == 0);
  for (const std::size_t same : {1u, 2u, 3u, 5u})
    CHECK(costs.replace(0, same) < 2 * costs.one);
  CHECK(costs.replace(0, 4) > 2 * costs.one);
  CHECK(costs.replace(0, 1) < costs.replace(0, 2));
  CHECK(costs.replace(0, 5) < costs.replace(0, 3));
}

}  // namespace
}  // namespace plsc
