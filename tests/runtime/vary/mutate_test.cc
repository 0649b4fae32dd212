#include "runtime/vary/mutate.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <set>
#include <utility>

#include "tests/runtime/vary/chi_square.h"
#include "tests/sanitizer.h"

namespace plsc {

namespace {

using test::kSignificance;
using test::PValue;

constexpr int kMutations = test::Sampled(20000);

/// A rule whose symbols all differ: T(0.00), T(0.01), ...; of C with C first.
Rule Numbered(SymbolId head, std::size_t length) {
  Rule rule;
  rule.head = head;
  for (std::size_t i = 0; i < length; ++i)
    rule.production.push_back(
        {plasticoding::kT, {static_cast<double>(i) / 100}});
  if (head == plasticoding::kC) rule.production[0] = {head, {}};
  return rule;
}

Rng Stream(std::uint64_t id) {
  return Rng({9004, 0, id, Purpose::kMutate});
}

Genotype Fresh(std::uint64_t id, const GenotypeOptions& options = {}) {
  Rng rng({9004, 0, id, Purpose::kInitialise});
  return Initialise(options, rng);
}

std::size_t Place(const Rule& rule, const Symbol& symbol) {
  return static_cast<std::size_t>(
      std::find(rule.production.begin(), rule.production.end(), symbol) -
      rule.production.begin());
}

std::vector<double> Even(std::size_t count) {
  return std::vector<double>(count, 1);
}

}  // namespace

TEST_CASE("Kinds, symbols and rules to mutate are drawn evenly", "[mutate]") {
  // The authors' counts of deletions, swaps, additions and clause changes in
  // 20,000 mutations, and the same for the Baseline.
  const std::vector<int> plastic = {4975, 5083, 4931, 5011};
  const std::vector<int> baseline = {6631, 6809, 6560};
  std::vector<int> kinds(4);
  std::vector<int> rules(10);
  const Genotype genotype = Fresh(1);
  for (int i = 0; i < kMutations; ++i) {
    Rng rng = Stream(static_cast<std::uint64_t>(i));
    const Mutation mutation =
        DrawMutation(genotype, Encoding::kPlasticoding, rng);
    ++kinds[static_cast<std::size_t>(mutation.kind)];
    ++rules[mutation.rule];
  }
  CHECK(PValue(kinds, plastic) > kSignificance);
  CHECK(PValue(rules, Even(10)) > kSignificance);

  std::vector<int> baseline_kinds(3);
  for (int i = 0; i < kMutations; ++i) {
    Rng rng = Stream(static_cast<std::uint64_t>(i));
    const Mutation mutation = DrawMutation(genotype, Encoding::kBaseline, rng);
    REQUIRE(mutation.kind != MutationKind::kClause);
    ++baseline_kinds[static_cast<std::size_t>(mutation.kind)];
  }
  CHECK(PValue(baseline_kinds, baseline) > kSignificance);
}

TEST_CASE("A symbol is chosen before one of its rules", "[mutate]") {
  // C has one rule, B three: each symbol is met as often all the same.
  Genotype genotype;
  genotype.rules = {
      Numbered(plasticoding::kC, 3), Numbered(plasticoding::kB, 3),
      Numbered(plasticoding::kB, 3), Numbered(plasticoding::kB, 3)};
  std::vector<int> rules(4);
  for (int i = 0; i < kMutations; ++i) {
    Rng rng = Stream(static_cast<std::uint64_t>(i));
    ++rules[DrawMutation(genotype, Encoding::kBaseline, rng).rule];
  }
  CHECK(PValue(rules, std::vector<double>{3, 1, 1, 1}) > kSignificance);
}

TEST_CASE("Deletions and swaps change a rule as often as the authors' do",
          "[mutate]") {
  // Their deletions and swaps on fresh genotypes: changed, unchanged.
  const std::vector<int> deletions = {4881, 94};
  const std::vector<int> swaps = {4325, 758};
  std::vector<int> deleted(2);
  std::vector<int> swapped(2);
  for (int i = 0; i < kMutations; ++i) {
    const auto id = static_cast<std::uint64_t>(i);
    const Genotype parent = Fresh(id);
    Rng rng = Stream(id);
    Mutation mutation = DrawMutation(parent, Encoding::kPlasticoding, rng);
    mutation.kind = MutationKind::kDelete;
    Rng again = rng;
    ++deleted[Mutate(parent, mutation, rng) == parent ? 1 : 0];
    mutation.kind = MutationKind::kSwap;
    ++swapped[Mutate(parent, mutation, again) == parent ? 1 : 0];
  }
  CHECK(PValue(deleted, deletions) > kSignificance);
  CHECK(PValue(swapped, swaps) > kSignificance);
}

TEST_CASE("Deletion takes any symbol but C, by its position", "[mutate]") {
  const Rule rule = Numbered(plasticoding::kB, 7);
  std::vector<int> places(7);
  const Rule of_core = Numbered(plasticoding::kC, 6);
  std::vector<int> core_places(6);  // 0: nothing deleted, as C was met
  for (int i = 0; i < kMutations; ++i) {
    Rng rng = Stream(static_cast<std::uint64_t>(i));
    const Rule child = DeleteSymbol(rule, rng);
    REQUIRE(child.production.size() == 6);
    std::size_t place = 0;
    while (place < 6 && child.production[place] == rule.production[place])
      ++place;
    ++places[place];
    const Rule core_child = DeleteSymbol(of_core, rng);
    REQUIRE(core_child.production[0].id == plasticoding::kC);
    place = 0;
    if (core_child != of_core) {
      while (place < 5 &&
             core_child.production[place] == of_core.production[place])
        ++place;
    }
    ++core_places[place];
  }
  CHECK(PValue(places, Even(7)) > kSignificance);
  CHECK(PValue(core_places, Even(6)) > kSignificance);
}

TEST_CASE("A rule of one symbol keeps it", "[mutate]") {
  for (const SymbolId head : {plasticoding::kB, plasticoding::kC}) {
    const Rule rule = Numbered(head, 1);
    Rng rng = Stream(1);
    CHECK(DeleteSymbol(rule, rng) == rule);
    CHECK(SwapSymbols(rule, rng) == rule);
  }
}

TEST_CASE("A swap exchanges two positions drawn independently", "[mutate]") {
  const std::size_t length = 5;
  const Rule rule = Numbered(plasticoding::kC, length);
  std::map<std::pair<std::size_t, std::size_t>, int> pairs;
  for (int i = 0; i < kMutations; ++i) {
    Rng rng = Stream(static_cast<std::uint64_t>(i));
    const Rule child = SwapSymbols(rule, rng);
    std::vector<std::size_t> moved;
    for (std::size_t k = 0; k < length; ++k)
      if (child.production[k] != rule.production[k]) moved.push_back(k);
    if (moved.empty()) {
      ++pairs[{0, 0}];
      continue;
    }
    REQUIRE(moved.size() == 2);
    REQUIRE(child.production[moved[0]] == rule.production[moved[1]]);
    REQUIRE(child.production[moved[1]] == rule.production[moved[0]]);
    ++pairs[{moved[0], moved[1]}];
  }
  // 25 ordered pairs: 9 with C and 4 of a symbol with itself change nothing.
  std::vector<int> counts;
  std::vector<double> expected;
  for (const auto& [pair, count] : pairs) {
    CHECK((pair.first > 0 || pair.second == 0));
    counts.push_back(count);
    expected.push_back(pair.second == 0 ? 13 : 2);
  }
  REQUIRE(counts.size() == 7);
  CHECK(PValue(counts, expected) > kSignificance);
}

TEST_CASE("Additions go anywhere, the end included, but not before C",
          "[mutate]") {
  const Alphabet& alphabet = *PlasticodingAlphabet();
  const Rule rule = Numbered(plasticoding::kB, 5);
  const Rule of_core = Numbered(plasticoding::kC, 5);
  const Rule lone_core = Numbered(plasticoding::kC, 1);
  std::vector<int> places(6);
  std::vector<int> core_places(5);
  for (int i = 0; i < kMutations; ++i) {
    Rng rng = Stream(static_cast<std::uint64_t>(i));
    const auto place = [&](const Rule& parent) {
      const Rule child = AddSymbol(parent, alphabet, rng);
      REQUIRE(child.production.size() == parent.production.size() + 1);
      for (const Symbol& symbol : child.production)
        if (Place(parent, symbol) == parent.production.size())
          return Place(child, symbol);
      FAIL("nothing was added");
      return std::size_t{0};
    };
    ++places[place(rule)];
    const std::size_t core_place = place(of_core);
    REQUIRE(core_place >= 1);
    ++core_places[core_place - 1];
    REQUIRE(place(lone_core) == 1);
  }
  CHECK(PValue(places, Even(6)) > kSignificance);
  CHECK(PValue(core_places, Even(5)) > kSignificance);
}

TEST_CASE("Added symbols are distributed as the authors' program draws them",
          "[mutate]") {
  // Of 4,931 additions, in Table 1's order without C.
  const std::vector<int> theirs = {255, 256, 251, 244, 324, 331, 340,
                                   250, 246, 239, 246, 458, 514, 170,
                                   154, 180, 158, 175, 140};
  const Rule parent = Numbered(plasticoding::kC, 1);
  std::vector<int> ours(theirs.size());
  for (int i = 0; i < kMutations; ++i) {
    Rng rng = Stream(static_cast<std::uint64_t>(i));
    const Rule child = AddSymbol(parent, *PlasticodingAlphabet(), rng);
    const auto id = static_cast<std::size_t>(child.production[1].id);
    REQUIRE(id >= 1);
    ++ours[id - 1];
  }
  CHECK(PValue(ours, theirs) > kSignificance);
}

}  // namespace plsc
