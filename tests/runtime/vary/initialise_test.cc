#include "runtime/vary/initialise.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "tests/runtime/vary/chi_square.h"
#include "tests/sanitizer.h"

namespace plsc {

namespace {

using test::kSignificance;
using test::PValue;

constexpr int kGenotypes = test::Sampled(20000);

Genotype Sample(const GenotypeOptions& options, std::uint64_t id) {
  Rng rng({9001, 0, id, Purpose::kInitialise});
  return Initialise(options, rng);
}

std::size_t Groups(const Rule& rule) {
  return (rule.production.size() - (rule.head == plasticoding::kC ? 1 : 0)) / 5;
}

}  // namespace

TEST_CASE("First symbols are distributed as the authors' program draws them",
          "[initialise]") {
  // Their counts over 20,000 plastic genotypes, in Table 1's order.
  const std::vector<int> theirs = {40000,  124951, 124842, 125181, 124816,
                                   166016, 166847, 166927, 125254, 125190,
                                   124491, 124855, 249982, 249808, 82578,
                                   83464,  83777,  83258,  83429,  83284};
  std::vector<int> ours(theirs.size());
  for (std::uint64_t id = 0; id < kGenotypes; ++id)
    for (const Rule& rule : Sample({}, id).rules)
      for (const Symbol& symbol : rule.production)
        ++ours[static_cast<std::size_t>(symbol.id)];
  CHECK(ours[0] == kGenotypes * 2);  // C: in front of its two rules
  // The number of groups is shared by all rules of a genotype, which makes
  // totals vary together; within a category, draws are independent.
  const std::vector<std::pair<std::size_t, std::size_t>> categories = {
      {1, 5}, {5, 8}, {8, 12}, {12, 14}, {14, 20}};
  for (const auto& [begin, end] : categories) {
    CAPTURE(begin, end);
    const auto first = static_cast<std::ptrdiff_t>(begin);
    const auto last = static_cast<std::ptrdiff_t>(end);
    CHECK(PValue(std::vector<int>(ours.begin() + first, ours.begin() + last),
                 std::vector<int>(theirs.begin() + first,
                                  theirs.begin() + last)) > kSignificance);
  }
}

TEST_CASE("The number of groups is drawn once a genotype", "[initialise]") {
  // Counts of the authors' program, 1 to 4 groups.
  const std::vector<int> theirs = {5010, 4979, 5033, 4978};
  std::vector<int> ours(4);
  for (std::uint64_t id = 0; id < kGenotypes; ++id) {
    const Genotype genotype = Sample({}, id);
    const std::size_t groups = Groups(genotype.rules.front());
    REQUIRE(groups >= 1);
    REQUIRE(groups <= 4);
    ++ours[groups - 1];
    for (const Rule& rule : genotype.rules) REQUIRE(Groups(rule) == groups);
  }
  CHECK(PValue(ours, theirs) > kSignificance);
}

TEST_CASE("The number of groups can be drawn for each rule", "[initialise]") {
  GenotypeOptions options;
  options.groups_per_rule = true;
  std::vector<int> pairs(16);  // of the two rules of B
  for (std::uint64_t id = 0; id < 4000; ++id) {
    const Genotype genotype = Sample(options, id);
    ++pairs[(Groups(genotype.rules[2]) - 1) * 4 + Groups(genotype.rules[3]) -
            1];
  }
  CHECK(PValue(pairs, std::vector<double>(16, 1)) > kSignificance);
}

TEST_CASE("Clauses are distributed as the authors' program draws them",
          "[initialise]") {
  // Of 200,000 rules, with the state inclined and at most 2 terms.
  const std::map<std::string, int> theirs = {
      {"inclined = False", 49808},
      {"inclined = False and inclined = False", 12615},
      {"inclined = False and inclined = True", 12625},
      {"inclined = False or inclined = False", 12310},
      {"inclined = False or inclined = True", 12560},
      {"inclined = True", 50022},
      {"inclined = True and inclined = False", 12504},
      {"inclined = True and inclined = True", 12348},
      {"inclined = True or inclined = False", 12628},
      {"inclined = True or inclined = True", 12580}};
  const std::vector<std::string> values = {"False", "True"};
  std::map<std::string, int> ours;
  for (std::uint64_t id = 0; id < kGenotypes; ++id) {
    const Genotype genotype = Sample({}, id);
    for (const Rule& rule : genotype.rules) {
      std::string form;
      for (std::size_t i = 0; i < rule.clause.terms.size(); ++i) {
        const Term& term = rule.clause.terms[i];
        REQUIRE(term.comparison == Comparison::kEqual);
        if (i > 0)
          form += rule.clause.connectives[i - 1] == Connective::kAnd ? " and "
                                                                     : " or ";
        form += "inclined = " + values[static_cast<std::size_t>(term.value)];
      }
      ++ours[form];
    }
  }
  REQUIRE(ours.size() == theirs.size());
  std::vector<int> our_counts;
  std::vector<int> their_counts;
  for (const auto& [form, count] : theirs) {
    our_counts.push_back(ours[form]);
    their_counts.push_back(count);
  }
  CHECK(PValue(our_counts, their_counts) > kSignificance);
}

TEST_CASE("With two states, each is asked about as often", "[initialise]") {
  GenotypeOptions options;
  options.states.push_back({"hot", StateType::kBool, 0, 0, {}});
  std::vector<int> ours(4);
  for (std::uint64_t id = 0; id < 5000; ++id)
    for (const Rule& rule : Sample(options, id).rules)
      for (const Term& term : rule.clause.terms)
        ++ours[static_cast<std::size_t>(term.state) * 2 +
               static_cast<std::size_t>(term.value)];
  CHECK(PValue(ours, std::vector<double>(4, 1)) > kSignificance);
}

TEST_CASE("Arguments are drawn as Table 1 says", "[initialise]") {
  // Deciles of weights in -1 to 1 and of oscillators in 1 to 10.
  std::vector<int> weights(10);
  std::vector<int> oscillators(10);
  std::vector<int> steps(5);
  std::vector<int> amounts(2);
  double sum_of_squares = 0;
  const auto decile = [](double x, double low, double high) {
    const auto tenth = static_cast<std::size_t>(10 * (x - low) / (high - low));
    return std::min<std::size_t>(tenth, 9);
  };
  for (std::uint64_t id = 0; id < 2000; ++id) {
    for (const Rule& rule : Sample({}, id).rules) {
      for (const Symbol& symbol : rule.production) {
        const auto& given = symbol.arguments;
        if (symbol.id == plasticoding::kA1) {
          ++weights[decile(given[plasticoding::kWeight], -1, 1)];
          for (std::size_t i = 1; i < 4; ++i)
            ++oscillators[decile(given[i], 1, 10)];
        } else if (symbol.id == plasticoding::kMoveRefI) {
          for (std::size_t i = 0; i < 2; ++i) {
            REQUIRE(given[i] == std::floor(given[i]));
            REQUIRE(given[i] >= 1);
            ++steps[std::min<std::size_t>(static_cast<std::size_t>(given[i]),
                                          5) -
                    1];
          }
        } else if (symbol.id == plasticoding::kMutateAmp) {
          ++amounts[given[0] < 0 ? 0 : 1];
          sum_of_squares += given[0] * given[0];
        }
      }
    }
  }
  const std::vector<double> even(10, 1);
  CHECK(PValue(weights, even) > kSignificance);
  CHECK(PValue(oscillators, even) > kSignificance);
  // Values of move_ref_I.t drawn by the authors' program: 1, 2, 3, 4, more.
  CHECK(PValue(steps, std::vector<int>{170054, 68504, 10741, 667, 16}) >
        kSignificance);
  CHECK(PValue(amounts, std::vector<double>{1, 1}) > kSignificance);
  const int n = amounts[0] + amounts[1];
  // The mean square of n normal numbers is 1 with deviation sqrt(2/n).
  CHECK(sum_of_squares / n == Approx(1).margin(4 * std::sqrt(2.0 / n)));
}

TEST_CASE("First genotypes have the shape that the options ask for",
          "[initialise]") {
  GenotypeOptions options;
  options.max_rules = 3;
  options.max_terms = 4;
  options.development.iterations = 2;
  const Genotype plastic = Sample(options, 1);
  CHECK(plastic.rules.size() == 15);
  CHECK(plastic.max_rules == 3);
  CHECK(plastic.max_terms == 4);
  CHECK(plastic.states == options.states);
  CHECK(plastic.development.iterations == 2);

  options.encoding = Encoding::kBaseline;
  const Genotype baseline = Sample(options, 1);
  CHECK(baseline.rules.size() == 5);
  CHECK(baseline.states.empty());
  for (const Rule& rule : baseline.rules) CHECK(rule.clause.is_always());
}

}  // namespace plsc
