#include "compiler/genotype.h"

#include <algorithm>
#include <cstring>

namespace plsc {

namespace {

// -0 and +0 are different numbers here: both print, and both must come back.
bool SameBits(double a, double b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

}  // namespace

bool operator==(const Term& a, const Term& b) {
  return a.state == b.state && a.comparison == b.comparison &&
         SameBits(a.value, b.value);
}

bool operator==(const Symbol& a, const Symbol& b) {
  return a.id == b.id && std::equal(a.arguments.begin(), a.arguments.end(),
                                    b.arguments.begin(), SameBits);
}

bool operator==(const Genotype& a, const Genotype& b) {
  return a.name == b.name &&
         (a.alphabet == b.alphabet || *a.alphabet == *b.alphabet) &&
         a.states == b.states && a.axiom == b.axiom &&
         a.development == b.development && a.max_terms == b.max_terms &&
         a.max_rules == b.max_rules && a.rules == b.rules;
}

}  // namespace plsc
