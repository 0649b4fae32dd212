// Every distribution of the authors' mutation, over 20,000 mutations of fresh
// genotypes of each kind. Their program finds symbols by value and never
// appends, so it is compared with these switches on; the others are told from
// it.

#include <catch2/catch.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "runtime/vary/mutate.h"
#include "tests/runtime/vary/chi_square.h"
#include "tests/runtime/vary/reference_statistics.h"

namespace plsc {

namespace {

using test::Tally;

constexpr std::uint64_t kCalls = 20000;
constexpr MutationOptions kTheirs = {0.25, InsertionPoint::kBeforeEnd,
                                     Removal::kByValue};

/// The authors' names of our kinds.
std::string KindName(MutationKind kind) {
  const std::vector<std::string> names = {"deletion", "swap", "addition",
                                          "clause"};
  return names[static_cast<std::size_t>(kind)];
}

/// Where `longer` has a symbol more than `shorter`: the first place where they
/// differ. Neighbours of fresh rules are of different categories, so a removed
/// symbol is told from the next one.
std::size_t FirstDifference(const std::vector<Symbol>& longer,
                            const std::vector<Symbol>& shorter) {
  std::size_t place = 0;
  while (place < shorter.size() && longer[place] == shorter[place]) ++place;
  return place;
}

std::string TermText(const Term& term, const Genotype& genotype) {
  return genotype.states[static_cast<std::size_t>(term.state)].name +
         (term.value == 1 ? "=True" : "=False");
}

class Observer {
 public:
  Tally tally;
  Tally detail;

  void Count(const Genotype& before, const Genotype& after,
             const Mutation& mutation) {
    const std::string kind = KindName(mutation.kind);
    tally.Count("kinds", kind);
    const Rule& old_rule = before.rules[mutation.rule];
    const Rule& rule = after.rules[mutation.rule];
    const bool is_changed = !(old_rule == rule);
    detail.Count(kind + ".effect", is_changed ? "changed" : "unchanged");
    if (!is_changed) return;
    detail.Count(kind + ".letter", (*before.alphabet)[rule.head].name);
    const bool is_second =
        mutation.rule > 0 && before.rules[mutation.rule - 1].head == rule.head;
    detail.Count(kind + ".which_rule", is_second ? "1" : "0");
    switch (mutation.kind) {
      case MutationKind::kDelete:
        CountPlace(kind, old_rule.production, rule, old_rule, before);
        break;
      case MutationKind::kSwap:
        CountSwap(old_rule.production, rule.production);
        break;
      case MutationKind::kAdd:
        CountPlace(kind, rule.production, old_rule, old_rule, before);
        break;
      case MutationKind::kClause:
        CountClause(old_rule.clause, rule.clause, before);
        break;
    }
  }

 private:
  void CountPlace(const std::string& kind, const std::vector<Symbol>& longer,
                  const Rule& shorter, const Rule& old_rule,
                  const Genotype& genotype) {
    const std::size_t place = FirstDifference(longer, shorter.production);
    const bool is_core = old_rule.head == plasticoding::kC;
    detail.Count(kind + ".index_in_rule_of_" + (is_core ? "C" : "other") +
                     "_length_" + std::to_string(old_rule.production.size()),
                 std::to_string(place));
    detail.Count(kind + ".symbol", (*genotype.alphabet)[longer[place].id].name);
  }

  void CountSwap(const std::vector<Symbol>& before,
                 const std::vector<Symbol>& after) {
    const std::size_t first = FirstDifference(before, after);
    std::size_t last = before.size() - 1;
    while (before[last] == after[last]) --last;
    detail.Count("swap.distance", std::to_string(last - first));
  }

  void CountClause(const Clause& before, const Clause& after,
                   const Genotype& genotype) {
    const std::size_t terms = before.terms.size();
    const std::string name =
        "clause.change_of_" + std::to_string(terms) + "_term_clause";
    if (after.terms.size() > terms) {
      detail.Count(name, "add_term");
      detail.Count("clause.added_operator",
                   after.connectives.back() == Connective::kAnd ? "and" : "or");
      detail.Count("clause.added_term", TermText(after.terms.back(), genotype));
    } else if (after.terms.size() < terms) {
      detail.Count(name, "remove_term");
      if (!(before.terms[0] == before.terms[1]))  // else nobody can tell
        detail.Count("clause.removed_position",
                     after.terms[0] == before.terms[0] ? "1" : "0");
    } else if (after.connectives != before.connectives) {
      detail.Count(name, "flip_operator");
    } else {
      detail.Count(name, "flip_value");
      if (terms == 2)
        detail.Count("clause.flipped_position_of_2",
                     after.terms[0] == before.terms[0] ? "1" : "0");
    }
  }
};

Observer MutateAll(const GenotypeOptions& options,
                   const MutationOptions& mutations, double probability) {
  Observer observer;
  for (std::uint64_t id = 0; id < kCalls; ++id) {
    Rng initial({9104, 0, id, Purpose::kInitialise});
    const Genotype before = Initialise(options, initial);
    Rng rng({9104, 1, id, Purpose::kMutate});
    if (!rng.Bernoulli(probability)) {
      observer.tally.Count("tried", "no");
      continue;
    }
    observer.tally.Count("tried", "yes");
    const Mutation mutation =
        DrawMutation(before, options.encoding, rng, mutations);
    observer.Count(before, Mutate(before, mutation, rng, mutations), mutation);
  }
  return observer;
}

GenotypeOptions TwoStates() {
  GenotypeOptions options;
  options.states.push_back({"hot", StateType::kBool, 0, 0, {}});
  return options;
}

GenotypeOptions Baseline() {
  GenotypeOptions options;
  options.encoding = Encoding::kBaseline;
  return options;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("Mutation with its switches changes as the authors' program does",
          "[mutate][slow]") {
  struct Row {
    const char* block;
    GenotypeOptions options;
    double probability;
  };
  const std::vector<Row> rows = {{"mutation_plastic", {}, 1},
                                 {"mutation_plastic_prob_0.8", {}, 0.8},
                                 {"mutation_two_states", TwoStates(), 1},
                                 {"mutation_baseline", Baseline(), 1}};
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.block) {
      const nlohmann::json theirs = test::ReferenceStatistics(row.block);
      const Observer ours = MutateAll(row.options, kTheirs, row.probability);
      CHECK(ours.tally.Disagreements(theirs, {"detail", "exceptions"}) ==
            Names{});
      CHECK(ours.detail.Disagreements(theirs.at("detail")) == Names{});
      const int tried = theirs.at("mutations_tried").get<int>();
      const nlohmann::json counts = {{"yes", tried},
                                     {"no", static_cast<int>(kCalls) - tried}};
      CHECK(ours.tally.Agreement(
                "tried",
                row.probability < 1 ? counts : nlohmann::json{{"yes", tried}}) >
            test::kSignificance);
    }
  }
}

TEST_CASE("The paper's mutation is told from the authors' by places alone",
          "[mutate][slow]") {
  // Both that our defaults agree with theirs in everything else, and that the
  // comparison above can fail.
  const nlohmann::json theirs = test::ReferenceStatistics("mutation_plastic");
  const auto disagreements = [&](const MutationOptions& options) {
    return MutateAll({}, options, 1).detail.Disagreements(theirs.at("detail"));
  };
  MutationOptions options = kTheirs;
  options.insertion = InsertionPoint::kAnywhere;
  const Names of_insertion = disagreements(options);
  CHECK(of_insertion.size() >= 4);
  for (const std::string& name : of_insertion) {
    CAPTURE(name);
    CHECK(name.starts_with("addition.index_in_rule_of_"));
  }
  options = kTheirs;
  options.removal = Removal::kByPosition;
  const Names of_removal = disagreements(options);
  CHECK_FALSE(of_removal.empty());
  for (const std::string& name : of_removal) {
    CAPTURE(name);
    CHECK(name.starts_with("deletion.index_in_rule_of_"));
  }
}

TEST_CASE("The share of clause changes is the one asked for", "[mutate]") {
  Rng initial({9104, 0, 1, Purpose::kInitialise});
  const Genotype genotype = Initialise({}, initial);
  for (const double share : {0.0, 0.1, 0.25, 0.6, 1.0}) {
    CAPTURE(share);
    MutationOptions options;
    options.clause_share = share;
    std::vector<int> kinds(4);
    for (std::uint64_t id = 0; id < kCalls; ++id) {
      Rng rng({9105, 0, id, Purpose::kMutate});
      ++kinds[static_cast<std::size_t>(
          DrawMutation(genotype, Encoding::kPlasticoding, rng, options).kind)];
    }
    const double other = (1 - share) / 3;
    if (share == 0) {
      CHECK(kinds[3] == 0);
      kinds.pop_back();
      CHECK(test::PValue(kinds, std::vector<double>(3, 1)) >
            test::kSignificance);
    } else if (share == 1) {
      CHECK(kinds[3] == static_cast<int>(kCalls));
    } else {
      CHECK(
          test::PValue(kinds, std::vector<double>{other, other, other, share}) >
          test::kSignificance);
      CHECK(test::PValue(kinds, std::vector<double>{1, 1, 1, 1.4}) <
            test::kSignificance);
    }
  }
}

TEST_CASE("An even share of kinds takes one random number", "[mutate]") {
  // So runs of versions without the option are repeated bit for bit.
  Rng initial({9104, 0, 1, Purpose::kInitialise});
  const Genotype genotype = Initialise({}, initial);
  for (std::uint64_t id = 0; id < 1000; ++id) {
    Rng rng({9106, 0, id, Purpose::kMutate});
    Rng plain = rng;
    const Mutation mutation =
        DrawMutation(genotype, Encoding::kPlasticoding, rng);
    REQUIRE(static_cast<std::size_t>(mutation.kind) == plain.Index(4));
    REQUIRE(mutation.rule == plain.Index(5) * 2 + plain.Index(2));
    REQUIRE(rng.Next() == plain.Next());
  }
}

TEST_CASE("The switches choose places as they say", "[mutate]") {
  // T B T B: by value, the second T and the second B mean the first ones.
  const Symbol t{plasticoding::kT, {0.5}};
  const Symbol b{plasticoding::kB, {}};
  const Rule rule = {plasticoding::kB, {}, {t, b, t, b}};
  const Rule core = {plasticoding::kC, {}, {{plasticoding::kC, {}}}};
  for (std::uint64_t id = 0; id < 1000; ++id) {
    Rng rng({9107, 0, id, Purpose::kMutate});
    const Rule deleted = DeleteSymbol(rule, rng, Removal::kByValue);
    REQUIRE((deleted.production == std::vector<Symbol>{b, t, b} ||
             deleted.production == std::vector<Symbol>{t, t, b}));
    const Rule swapped = SwapSymbols(rule, rng, Removal::kByValue);
    REQUIRE((swapped == rule ||
             swapped.production == std::vector<Symbol>{b, t, t, b}));
    const Rule added = AddSymbol(rule, *PlasticodingAlphabet(), rng,
                                 InsertionPoint::kBeforeEnd);
    REQUIRE(added.production.size() == 5);
    REQUIRE(added.production.back() == b);
    // Where their program fails, the only place there is.
    const Rule grown = AddSymbol(core, *PlasticodingAlphabet(), rng,
                                 InsertionPoint::kBeforeEnd);
    REQUIRE(grown.production.size() == 2);
    REQUIRE(grown.production[0].id == plasticoding::kC);
  }
}

}  // namespace plsc
