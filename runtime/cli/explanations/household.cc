// Explanations of the codes that housekeeping gives: P4003, P5200, W5200.

#include "runtime/cli/explanations/explanations.h"

namespace plsc::cli {

namespace {

constexpr Explanation kHouseholdRows[] = {
    {Code::kTooManyEnvironments, ExampleKind::kTrim,
     R"('plsc trim' develops the robot of every environment that the clauses tell
apart, before and after, and here there are too many (more than 65,536, or
too many rules for that number). Clauses that ask about fewer states, or
real states with fewer thresholds, tell fewer apart.
)",
     R"(plsc 1
alphabet plasticoding 1
iterations 1
sense a: bool sense b: bool sense c: bool
sense d: bool sense e: bool sense f: bool
sense g: bool sense h: bool sense i: bool
sense j: bool sense k: bool sense l: bool
sense m: bool sense n: bool sense o: bool
sense p: bool sense q: bool
rule C -> if a = True and b = True and c = True and d = True and
  e = True and f = True and g = True and h = True and i = True and
  j = True and k = True and l = True and m = True and n = True and
  o = True and p = True and q = True
then { C add_left B }
rule C -> { C }
)",
     R"(plsc 1
alphabet plasticoding 1
iterations 1
sense a: bool sense b: bool sense c: bool
sense d: bool sense e: bool sense f: bool
sense g: bool sense h: bool sense i: bool
sense j: bool sense k: bool sense l: bool
sense m: bool sense n: bool sense o: bool
sense p: bool sense q: bool
rule C -> if a = True and b = True
then { C add_left B }
rule C -> { C }
)"},
    {Code::kNotAuthors, ExampleKind::kImport,
     R"(A genotype of Revolve, the authors' program, that 'plsc import' cannot
read: a bracket, a name or a number is not where Revolve writes it, or a
letter has two rules. Also a genotype of plsc for which Revolve has no
words: an alphabet of its own, states that are not True or False.
)",
     R"({<Alphabet.BLOCK: 'B'>: [[<Alphabet.SENSOR: 'ST'>, [half]]]}
)",
     R"({<Alphabet.BLOCK: 'B'>: [[<Alphabet.SENSOR: 'ST'>, [0.5]]]}
)"},
    {Code::kLost, ExampleKind::kImport,
     R"(What is lost between plsc and Revolve, the authors' program: numbers that
were rounded when they were written, an empty rule, a last symbol that
Revolve itself would drop (it wants a blank behind it), symbols that it
joined to a rule before it wrote the genotype, settings that its text
does not have. The genotype is translated all the same.
)",
     R"(B addf ST_0.5
)",
     "B addf ST_0.5 \n"},
};

}  // namespace

std::span<const Explanation> HouseholdExplanations() {
  return kHouseholdRows;
}

}  // namespace plsc::cli
