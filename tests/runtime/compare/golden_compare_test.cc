#include "runtime/compare/golden_compare.h"

#include <catch2/catch.hpp>
#include <functional>

#include "tests/runtime/compare/golden_sample.h"

namespace plsc {
namespace {

std::vector<std::string> ReportedLines(const Observation& expected,
                                       const Observation& found,
                                       double tolerance = 1e-9) {
  std::vector<std::string> lines;
  for (const Difference& difference : Compare(expected, found, tolerance))
    lines.push_back(Describe(difference));
  return lines;
}

TEST_CASE("Compare says what differs, in words", "[golden]") {
  struct Row {
    const char* why;
    std::function<void(Observation&)> change;
    std::vector<std::string> told;
  };
  const std::vector<Row> rows = {
      {"nothing", [](Observation&) {}, {}},
      {"the environment has another meaning",
       [](Observation& o) { o.senses = "inclined=False"; },
       {"what the environment means: expected inclined=True, found "
        "inclined=False"}},
      {"another rule is active",
       [](Observation& o) {
         o.active_rules = {1, 2, 3};
       },
       {"active rules: expected 1 3, found 1 2 3"}},
      {"no rule is active",
       [](Observation& o) { o.active_rules.clear(); },
       {"active rules: expected 1 3, found none"}},
      {"a symbol is another",
       [](Observation& o) { o.string.symbols[1] = "add_left"; },
       {"string at symbol 2: expected add_front, found add_left"}},
      {"a symbol more",
       [](Observation& o) {
         o.string.symbols.insert(o.string.symbols.begin() + 3, "loop(1)");
         o.string.length = 5;
       },
       {"string at symbol 4: expected nothing, found loop(1)",
        "length of the string: expected 4, found 5"}},
      {"the end is missing",
       [](Observation& o) {
         o.string.symbols.pop_back();
         o.string.length = 3;
       },
       {"string at symbol 4: expected T(0.75), found nothing",
        "length of the string: expected 4, found 3"}},
      {"no body",
       [](Observation& o) { o.robot.reset(); },
       {"body and brain missing"}},
      {"a descriptor",
       [](Observation& o) { o.robot->body_descriptors[1].second = 6; },
       {"descriptor width: expected 5, found 6"}},
      {"a descriptor of the brain",
       [](Observation& o) { o.robot->brain_descriptors[0].second = 0; },
       {"descriptor recurrence: expected 0.25, found 0"}},
      {"a descriptor is gone, another new",
       [](Observation& o) { o.robot->body_descriptors[0].first = "charm"; },
       {"descriptor branching missing", "descriptor charm added"}},
      {"the weight of an edge",
       [](Observation& o) { o.robot->edges[0].weight = 0.25; },
       {"weight of edge node3->node1: expected 0.5, found 0.25"}},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      Observation found = test::GoldenSample();
      row.change(found);
      CHECK(ReportedLines(test::GoldenSample(), found) == row.told);
    }
  }
}

TEST_CASE("long differences of strings are shortened", "[golden]") {
  Observation found = test::GoldenSample();
  found.string.symbols.assign(40, "loop(1)");
  found.string.length = 40;
  CHECK(ReportedLines(test::GoldenSample(), found)[0] ==
        "string at symbol 1: expected C add_front B T(0.75), found loop(1) "
        "loop(1) loop(1) loop(1) loop(1) loop(1) ... (40 symbols)");
}

TEST_CASE("strings beyond what is written out are compared by hash",
          "[golden]") {
  Observation expected = test::GoldenSample();
  expected.string.length = 900;
  expected.string.hash = "00000000000000aa";
  Observation found = expected;
  CHECK(ReportedLines(expected, found).empty());
  found.string.hash = "00000000000000bb";
  CHECK(ReportedLines(expected, found) ==
        std::vector<std::string>{"hash of the string: expected "
                                 "00000000000000aa, found 00000000000000bb"});
  found.string.length = 901;
  CHECK(ReportedLines(expected, found) ==
        std::vector<std::string>{
            "length of the string: expected 900, found 901"});
}

TEST_CASE("the tolerance is for descriptors only", "[golden]") {
  const Observation expected = test::GoldenSample();
  Observation found = expected;
  found.robot->body_descriptors[0].second += 1e-10;
  CHECK(ReportedLines(expected, found).empty());
  CHECK(ReportedLines(expected, found, 0).size() == 1);
  found.robot->body_descriptors[0].second += 1e-8;
  CHECK(ReportedLines(expected, found).size() == 1);
  SECTION("it is relative above 1") {
    found = expected;
    found.robot->body_descriptors[1].second += 4e-9;
    CHECK(ReportedLines(expected, found).empty());
    found.robot->body_descriptors[1].second += 4e-9;
    CHECK(ReportedLines(expected, found).size() == 1);
  }
  SECTION("weights are exact") {
    found = expected;
    found.robot->nodes[0].weight += 1e-15;
    CHECK(ReportedLines(expected, found).size() == 1);
  }
}

}  // namespace
}  // namespace plsc
