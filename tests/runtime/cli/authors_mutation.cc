#include "tests/runtime/cli/authors_mutation.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace plsc::test {

namespace {

using Symbols = std::vector<Symbol>;
using Offset = Symbols::difference_type;

// Where Python's list.index finds an equal symbol.
std::size_t FirstEqual(const Symbols& rule, std::size_t place) {
  return static_cast<std::size_t>(
      std::find(rule.begin(), rule.end(), rule[place]) - rule.begin());
}

bool IsDeleted(const Symbols& rule, const Symbols& child, bool by_place) {
  if (rule.size() < 2) return false;
  for (std::size_t i = 0; i < rule.size(); ++i) {
    if (rule[i].id == plasticoding::kC) continue;
    Symbols made = rule;
    made.erase(made.begin() +
               static_cast<Offset>(by_place ? i : FirstEqual(rule, i)));
    if (made == child) return true;
  }
  return false;
}

bool IsSwapped(const Symbols& rule, const Symbols& child, bool by_place) {
  for (std::size_t i = 0; i < rule.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (rule[i].id == plasticoding::kC || rule[k].id == plasticoding::kC)
        continue;
      Symbols made = rule;
      std::swap(made[by_place ? i : FirstEqual(rule, i)],
                made[by_place ? k : FirstEqual(rule, k)]);
      if (made == child) return true;
    }
  }
  return false;
}

bool IsAdded(const Symbols& rule, const Symbols& child, bool at_end) {
  if (child.size() != rule.size() + 1) return false;
  const std::size_t first = rule.front().id == plasticoding::kC ? 1 : 0;
  const std::size_t end = child.size() - (at_end || rule.size() == 1 ? 0 : 1);
  for (std::size_t i = first; i < end; ++i) {
    Symbols made = rule;
    made.insert(made.begin() + static_cast<Offset>(i), child[i]);
    if (made == child && child[i].id != plasticoding::kC) return true;
  }
  return false;
}

bool IsChangedClause(const Clause& clause, const Clause& child) {
  const std::size_t terms = clause.terms.size();
  for (std::size_t i = 0; i < terms; ++i) {
    Clause made = clause;
    made.terms[i].value = 1 - made.terms[i].value;
    if (made == child) return true;
  }
  for (std::size_t i = 0; i < terms && terms > 1; ++i) {
    Clause made = clause;
    made.terms.erase(made.terms.begin() + static_cast<Offset>(i));
    made.connectives.erase(made.connectives.begin() +
                           static_cast<Offset>(i == 0 ? 0 : i - 1));
    if (made == child) return true;
  }
  for (std::size_t i = 0; i + 1 < terms; ++i) {
    Clause made = clause;
    made.connectives[i] = made.connectives[i] == Connective::kAnd
                              ? Connective::kOr
                              : Connective::kAnd;
    if (made == child) return true;
  }
  // It counts terms and operators, and appends only to less than two.
  if (terms != 1 || child.terms.size() != 2) return false;
  return child.terms[0] == clause.terms[0] &&
         child.terms[1].comparison == Comparison::kEqual;
}

}  // namespace

bool AuthorsCanMake(const Genotype& parent, const Genotype& child,
                    bool as_in_paper) {
  if (parent.rules.size() != child.rules.size()) return false;
  int changed = 0;
  for (std::size_t i = 0; i < parent.rules.size(); ++i) {
    const Rule& from = parent.rules[i];
    const Rule& to = child.rules[i];
    if (from == to) continue;
    if (++changed > 1 || from.head != to.head) return false;
    const bool is_made =
        from.production == to.production
            ? IsChangedClause(from.clause, to.clause)
            : from.clause == to.clause &&
                  (IsDeleted(from.production, to.production, as_in_paper) ||
                   IsSwapped(from.production, to.production, as_in_paper) ||
                   IsAdded(from.production, to.production, as_in_paper));
    if (!is_made) return false;
  }
  return true;
}

}  // namespace plsc::test
