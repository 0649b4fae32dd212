// Changes of clauses, the fourth kind of mutation in runtime/vary/mutate.

#include <catch2/catch.hpp>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "runtime/vary/mutate.h"
#include "tests/runtime/vary/chi_square.h"
#include "tests/sanitizer.h"

namespace plsc {

namespace {

using test::kSignificance;
using test::PValue;

constexpr int kClauseSamples = test::Sampled(20000);

const State kInclined = {"inclined", StateType::kBool, 0, 0, {}};
const State kHot = {"hot", StateType::kBool, 0, 0, {}};
const State kTemperature = {"temperature", StateType::kReal, -40, 60, {}};
const State kGround = {
    "ground", StateType::kEnum, 0, 0, {"sand", "rock", "wet"}};

Term Is(int state, double value) {
  return {static_cast<StateId>(state), Comparison::kEqual, value};
}

/// "0=1 and 1=0": states by number.
std::string Text(const Clause& clause) {
  const std::vector<std::string> signs = {"=", "!=", "<", "<=", ">", ">="};
  std::string text;
  for (std::size_t i = 0; i < clause.terms.size(); ++i) {
    const Term& term = clause.terms[i];
    if (i > 0)
      text += clause.connectives[i - 1] == Connective::kAnd ? " and " : " or ";
    text += std::to_string(static_cast<int>(term.state)) +
            signs[static_cast<std::size_t>(term.comparison)] +
            std::to_string(static_cast<int>(term.value));
  }
  return text;
}

std::map<std::string, int> Changes(const Clause& clause,
                                   const std::vector<State>& states,
                                   std::optional<int> max_terms) {
  std::map<std::string, int> counts;
  for (int i = 0; i < kClauseSamples; ++i) {
    Rng rng({9006, 0, static_cast<std::uint64_t>(i), Purpose::kMutate});
    ++counts[Text(ChangeClause(clause, states, max_terms, rng))];
  }
  return counts;
}

struct Row {
  const char* why;
  Clause clause;
  std::vector<State> states;
  std::optional<int> max_terms;
  std::map<std::string, double> expected;  ///< relative frequencies
};

}  // namespace

TEST_CASE("Each possible change of a clause is as likely", "[mutate]") {
  using enum Connective;
  const std::vector<Row> rows = {
      {"one term: flip it or append one of two values with either operator",
       {{Is(0, 1)}, {}},
       {kInclined},
       2,
       {{"0=0", 4},
        {"0=1 and 0=0", 1},
        {"0=1 and 0=1", 1},
        {"0=1 or 0=0", 1},
        {"0=1 or 0=1", 1}}},
      {"one term at the limit of one: only flip",
       {{Is(0, 1)}, {}},
       {kInclined},
       1,
       {{"0=0", 1}}},
      {"two terms at the limit of two: flip, remove, flip the operator",
       {{Is(0, 1), Is(1, 0)}, {kAnd}},
       {kInclined, kHot},
       2,
       {{"0=0 and 1=0", 1},
        {"0=1 and 1=1", 1},
        {"0=1", 1},
        {"1=0", 1},
        {"0=1 or 1=0", 2}}},
      {"terms are counted, not terms and operators: two of three have room",
       {{Is(0, 1), Is(0, 0)}, {kOr}},
       {kInclined},
       3,
       {{"0=0 or 0=0", 2},
        {"0=1 or 0=1", 2},
        {"0=1", 2},
        {"0=0", 2},
        {"0=1 and 0=0", 4},
        {"0=1 or 0=0 and 0=0", 1},
        {"0=1 or 0=0 and 0=1", 1},
        {"0=1 or 0=0 or 0=0", 1},
        {"0=1 or 0=0 or 0=1", 1}}},
      {"no limit: there is always room",
       {{Is(0, 0)}, {}},
       {kInclined},
       std::nullopt,
       {{"0=1", 4},
        {"0=0 and 0=0", 1},
        {"0=0 and 0=1", 1},
        {"0=0 or 0=0", 1},
        {"0=0 or 0=1", 1}}},
      {"a clause that always holds gets a first term",
       {{}, {}},
       {kInclined},
       2,
       {{"0=0", 1}, {"0=1", 1}}},
      {"no states, no terms: nothing to change", {{}, {}}, {}, 2, {{"", 1}}},
      {"an enum becomes any other comparison or value",
       {{Is(0, 1)}, {}},
       {kGround},
       1,
       {{"0=0", 1}, {"0=2", 1}, {"0!=0", 1}, {"0!=1", 1}, {"0!=2", 1}}},
      {"removal of a middle term takes the operator before it",
       {{Is(0, 0), Is(1, 0), Is(0, 1)}, {kAnd, kOr}},
       {kInclined, kHot},
       3,
       {{"0=1 and 1=0 or 0=1", 2},
        {"0=0 and 1=1 or 0=1", 2},
        {"0=0 and 1=0 or 0=0", 2},
        {"1=0 or 0=1", 2},
        {"0=0 or 0=1", 2},
        {"0=0 and 1=0", 2},
        {"0=0 or 1=0 or 0=1", 3},
        {"0=0 and 1=0 and 0=1", 3}}}};
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const auto counts = Changes(row.clause, row.states, row.max_terms);
      std::set<std::string> expected_texts;
      std::vector<int> seen;
      std::vector<double> expected;
      for (const auto& [text, weight] : row.expected) {
        const auto found = counts.find(text);
        CAPTURE(text);
        REQUIRE(found != counts.end());
        seen.push_back(found->second);
        expected.push_back(weight);
      }
      CHECK(counts.size() == row.expected.size());
      if (seen.size() > 1) CHECK(PValue(seen, expected) > kSignificance);
    }
  }
}

TEST_CASE("A term about a real state gets a fresh order and number",
          "[mutate]") {
  const Clause clause = {{{StateId{0}, Comparison::kGreater, 30.5}}, {}};
  std::vector<int> orders(4);
  std::vector<int> tenths(10);
  for (int i = 0; i < kClauseSamples; ++i) {
    Rng rng({9007, 0, static_cast<std::uint64_t>(i), Purpose::kMutate});
    const Clause child = ChangeClause(clause, {kTemperature}, 1, rng);
    REQUIRE(child.terms.size() == 1);
    const Term& term = child.terms[0];
    REQUIRE(term.comparison >= Comparison::kLess);
    ++orders[static_cast<std::size_t>(term.comparison) - 2];
    REQUIRE(term.value >= -40);
    REQUIRE(term.value <= 60);
    ++tenths[static_cast<std::size_t>((term.value + 40) / 10)];
  }
  CHECK(PValue(orders, std::vector<double>(4, 1)) > kSignificance);
  CHECK(PValue(tenths, std::vector<double>(10, 1)) > kSignificance);
}

TEST_CASE("Clauses of fresh genotypes change as in the authors' program",
          "[mutate]") {
  // Their changes of one-term clauses: append, flip; of two-term clauses: flip
  // the operator, flip a value, remove a term.
  const std::vector<int> one_term = {1253, 1193};
  const std::vector<int> two_terms = {825, 878, 862};
  std::vector<int> one(2);
  std::vector<int> two(3);
  for (int i = 0; i < kClauseSamples; ++i) {
    const auto id = static_cast<std::uint64_t>(i);
    Rng rng({9004, 0, id, Purpose::kInitialise});
    const Genotype parent = Initialise({}, rng);
    const Clause& before = parent.rules[0].clause;
    const Clause after = ChangeClause(before, parent.states, 2, rng);
    if (before.terms.size() == 1)
      ++one[after.terms.size() == 2 ? 0 : 1];
    else if (after.connectives != before.connectives && after.terms.size() == 2)
      ++two[0];
    else
      ++two[after.terms.size() == 2 ? 1 : 2];
  }
  CHECK(PValue(one, one_term) > kSignificance);
  CHECK(PValue(two, two_terms) > kSignificance);
}

}  // namespace plsc
