#include "runtime/pictures/bodies_svg.h"

#include "tests/runtime/develop/grown.h"
#include "tests/runtime/pictures/count.h"

namespace plsc {
namespace {

using test::Count;

DrawnBody Drawn(const std::string& name, const std::string& symbols,
                std::vector<RuleIndex> rules = {}) {
  return {name, "", test::GrowProduction(symbols).trace().phenotype.body,
          std::move(rules)};
}

TEST_CASE("a legend has what occurs, and the differences from the first",
          "[bodies_svg]") {
  struct Row {
    const char* why;
    std::vector<DrawnBody> bodies;
    std::vector<const char*> shown;
    std::vector<const char*> absent;
  };
  const std::vector<Row> rows = {
      {"one body",
       {Drawn("flat", "add_left A2(0,1,1,1)")},
       {">core<", ">horizontal joint<"},
       {">brick<", ">touch sensor<", "there in"}},
      {"the same body twice",
       {Drawn("flat", "add_left B"), Drawn("hot", "add_left B")},
       {">brick<", ">flat<", ">hot<"},
       {"there in", "another module"}},
      {"a new module",
       {Drawn("flat", ""), Drawn("hot", "add_left B add_front T(1)")},
       {">touch sensor<", ">not there in flat<"},
       {"only<", "another module"}},
      {"a missing and another module",
       {Drawn("flat", "add_left B add_right B"), Drawn("hot", "add_left T(1)")},
       {">another module than in flat<", ">there in flat only<"},
       {"not there in"}},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const std::string svg = BodiesSvg("robot", row.bodies);
      CHECK(Count(svg, R"(<g class="panel")") == row.bodies.size());
      for (const char* text : row.shown) {
        INFO(text);
        CHECK(Count(svg, text) > 0);
      }
      for (const char* text : row.absent) {
        INFO(text);
        CHECK(Count(svg, text) == 0);
      }
    }
  }
}

TEST_CASE("a rule has one colour in all bodies and the legend",
          "[bodies_svg]") {
  const std::vector<DrawnBody> bodies{Drawn("flat", "add_left B", {4, 2}),
                                      Drawn("hot", "", {kNoRule})};
  CHECK(RulesOf(bodies) == std::vector<RuleIndex>{2, 4, kNoRule});
  const std::string svg = BodiesByRuleSvg(
      "robot", bodies, {"", "", "rule 3: B, always", "", "rule 5: C, <b>"});
  CHECK(Count(svg, ">rule 3<") == 1);
  CHECK(Count(svg, ">rule 3: B, always<") == 1);
  CHECK(Count(svg, ">rule 5: C, &lt;b&gt;<") == 1);
  CHECK(Count(svg, ">the axiom<") == 1);
  // The module and its legend.
  CHECK(Count(svg, R"(fill="#e69f00")") == 2);
  CHECK(Count(svg, R"(fill="#56b4e9")") == 2);
  CHECK(Count(svg, ">core<") == 0);
}

TEST_CASE("cores lie on one line", "[bodies_svg]") {
  const std::string svg = BodiesSvg(
      "robot",
      {Drawn("a", ""), Drawn("b", "add_front B move_front add_front B")});
  const auto down = [&](std::size_t from) {
    const std::size_t at =
        svg.find("translate(", svg.find("class=\"panel\"", from));
    return svg.substr(svg.find(' ', at), svg.find(')', at) - svg.find(' ', at));
  };
  CHECK(down(0) == down(svg.find("class=\"panel\"") + 1));
}

}  // namespace
}  // namespace plsc
