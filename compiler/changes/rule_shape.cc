// Which rule is an edited one? The cost of taking rule j for rule i is by what
// they have in common: symbols as multisets (an inserted symbol must not make
// all behind it differ), half of it with arguments and half without. The order
// of symbols does not count; two mutations of a rule leave most of the symbols,
// two unrelated rules share some commands by chance.
//
// More than twice the cost of a deletion means "never": FindEdit then deletes
// and inserts. So a rule with another clause and less than a quarter in common
// is another rule, and a difference says so instead of telling of a rule in
// which everything changed.

#include "compiler/changes/rule_shape.h"

#include <algorithm>
#include <cstddef>

namespace plsc {

namespace {

constexpr int kOneRule = 1000;     // to delete or to insert
constexpr int kOtherClause = 500;  // the rest being equal
constexpr int kOtherBody = 900;    // when nothing is in common
constexpr int kOtherRule = 2 * kOneRule + 1;
// A quarter in common: the mounting commands and moves of two unrelated rules
// seldom make up more, and two mutations of a rule of five symbols leave more.
constexpr double kLeastAlike = 0.25;

// Sorted copies, of which many comparisons are made.
struct SortedShape {
  int clause = 0;
  std::vector<int> symbols;
  std::vector<int> names;
};

std::vector<SortedShape> SortedOf(const std::vector<RuleShape>& shapes) {
  std::vector<SortedShape> sorted;
  sorted.reserve(shapes.size());
  for (const RuleShape& shape : shapes) {
    sorted.push_back({shape.clause, shape.symbols, shape.names});
    std::sort(sorted.back().symbols.begin(), sorted.back().symbols.end());
    std::sort(sorted.back().names.begin(), sorted.back().names.end());
  }
  return sorted;
}

// Share of the longer list that both have, 0 to 1.
double InCommon(const std::vector<int>& a, const std::vector<int>& b) {
  std::size_t common = 0;
  auto i = a.begin();
  auto j = b.begin();
  while (i != a.end() && j != b.end()) {
    if (*i == *j) {
      ++common;
      ++i;
      ++j;
    } else if (*i < *j) {
      ++i;
    } else {
      ++j;
    }
  }
  const std::size_t longer = std::max(a.size(), b.size());
  return longer == 0
             ? 1
             : static_cast<double>(common) / static_cast<double>(longer);
}

int CostOf(const SortedShape& from, const SortedShape& to) {
  // Symbols with other arguments count half.
  const double alike =
      (InCommon(from.symbols, to.symbols) + InCommon(from.names, to.names)) / 2;
  const bool is_other_clause = from.clause != to.clause;
  if (is_other_clause && alike < kLeastAlike) return kOtherRule;
  return 1 + static_cast<int>(kOtherBody * (1 - alike)) +
         (is_other_clause ? kOtherClause : 0);
}

}  // namespace

EditCosts CostsOfRules(const std::vector<RuleShape>& from,
                       const std::vector<RuleShape>& to) {
  return {kOneRule, [&from, &to, sorted_from = SortedOf(from),
                     sorted_to = SortedOf(to)](std::size_t i, std::size_t j) {
            if (from[i] == to[j]) return 0;
            return CostOf(sorted_from[i], sorted_to[j]);
          }};
}

}  // namespace plsc
