#include "compiler/state_space.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "compiler/compiled.h"
#include "compiler/random_genotype.h"
#include "compiler/truth.h"

namespace plsc {
namespace {

using testing::Compiled;

// The classes of the only state of a genotype, as `plsc regulate` shows them.
std::string Labels(const std::string& type, const std::string& clause) {
  const Genotype genotype =
      Compiled("plsc 1 alphabet plasticoding 1 sense s: " + type +
               " rule B -> if " + clause + " then { B }")
          .genotype;
  const StateSpace space(genotype);
  std::string text;
  for (const ValueClass& values : space.classes(0))
    text += (text.empty() ? "" : " ") + ClassLabel(values, genotype.states[0]);
  return text;
}

TEST_CASE("Values that no term tells apart are one class", "[state_space]") {
  struct Row {
    const char* why;
    const char* type;
    const char* clause;
    const char* labels;
  };
  const std::vector<Row> rows = {
      {"bool", "bool", "s = True", "False True"},
      {"above", "real in 0..10", "s > 4", "0..4 >4..10"},
      {"from", "real in 0..10", "s >= 4", "0..<4 4..10"},
      {"below", "real in 0..10", "s < 4", "0..<4 4..10"},
      {"up to", "real in 0..10", "s <= 4", "0..4 >4..10"},
      {"exactly", "real in 0..10", "s = 4", "0..<4 4 >4..10"},
      {"exactly the lowest", "real in 0..10", "s = 0", "0 >0..10"},
      {"exactly the highest", "real in 0..10", "s != 10", "0..<10 10"},
      {"two thresholds", "real in 0..10", "s < 4 or s > 6",
       "0..<4 4..6 >6..10"},
      {"one threshold twice", "real in 0..10", "s < 4 or s > 4",
       "0..<4 4 >4..10"},
      {"out of reach above", "real in 0..10", "s > 10", "0..10"},
      {"out of reach below", "real in 0..10", "s < -5", "0..10"},
      {"one value named", "{ a, b, c }", "s = a", "a b|c"},
      {"the middle value named", "{ a, b, c }", "s != b", "a|c b"},
      {"two named", "{ a, b, c, d }", "s = d or s = a", "a b|c d"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      CHECK(Labels(row.type, row.clause) == row.labels);
    }
  }
}

TEST_CASE("Neighbouring doubles leave nothing between them", "[state_space]") {
  State state;
  state.type = StateType::kReal;
  state.low = 1;
  state.high = std::nextafter(1.0, 2.0);
  Clause clause;
  clause.terms = {{StateId{0}, Comparison::kEqual, state.low},
                  {StateId{0}, Comparison::kEqual, state.high}};
  clause.connectives = {Connective::kOr};
  const Clause* const one = &clause;
  const StateSpace space({&one, 1}, {state});
  REQUIRE(space.size() == 2);
  CHECK(space.At(0)[0] == state.low);
  CHECK(space.At(1)[0] == state.high);
}

TEST_CASE("The last state varies fastest", "[state_space]") {
  const Genotype genotype =
      Compiled(
          "plsc 1 alphabet plasticoding 1 sense a: bool sense unused: bool "
          "sense e: { x, y, z } rule B -> if e = x and a = True then { B }")
          .genotype;
  const StateSpace space(genotype);
  REQUIRE(space.size() == 4);
  CHECK(space.states() == std::vector<StateId>{StateId{0}, StateId{2}});
  CHECK(space.At(1) == std::vector<double>{0, 0, 1});
  CHECK(space.At(2) == std::vector<double>{1, 0, 0});
  CHECK(space.Describe(3, genotype.states) == "a = True and e = y|z");
}

TEST_CASE("Environments are described as clauses", "[state_space]") {
  const Genotype genotype =
      Compiled(
          "plsc 1 alphabet plasticoding 1 sense r: real in 0..10 "
          "rule B -> if r >= 2 and r < 4 or r = 7 then { B }")
          .genotype;
  const StateSpace space(genotype);
  std::vector<std::string> found;
  for (int i = 0; i < *space.size(); ++i)
    found.push_back(space.Describe(i, genotype.states));
  CHECK(found == std::vector<std::string>{"r < 2", "r >= 2 and r < 4",
                                          "r >= 4 and r < 7", "r = 7",
                                          "r > 7"});
  const StateSpace nothing({}, genotype.states);
  CHECK(nothing.size() == 1);
  CHECK(nothing.Describe(0, genotype.states) == "always");
}

// The oracle: any values at all, also those between the doubles that the
// space chose, activate the same rules as one of its environments.
TEST_CASE("Every environment is like one of the space", "[state_space]") {
  std::mt19937 random(7);  // NOLINT(bugprone-random-generator-seed)
  int checked = 0;
  for (std::uint32_t seed = 1; seed <= 400; ++seed) {
    const Genotype genotype = testing::RandomProgram(seed).genotype;
    const StateSpace space(genotype);
    if (!space.size() || *space.size() > 2000) continue;
    const auto active = [&](const std::vector<double>& values) {
      std::vector<bool> holds;
      for (const Rule& rule : genotype.rules)
        holds.push_back(ClauseHolds(rule.clause, values));
      return holds;
    };
    std::vector<std::vector<bool>> known;
    for (int i = 0; i < *space.size(); ++i)
      known.push_back(active(space.At(i)));
    for (int trial = 0; trial < 20; ++trial) {
      std::vector<double> values;
      for (const State& state : genotype.states) {
        const double part = static_cast<double>(random()) / 4294967295.0;
        if (state.type == StateType::kReal)
          values.push_back(std::min(
              state.high, state.low + part * (state.high - state.low)));
        else
          values.push_back(static_cast<double>(
              random() %
              (state.type == StateType::kBool ? 2 : state.values.size())));
      }
      CAPTURE(seed);
      REQUIRE(std::find(known.begin(), known.end(), active(values)) !=
              known.end());
      ++checked;
    }
  }
  CHECK(checked > 1000);
}

}  // namespace
}  // namespace plsc
