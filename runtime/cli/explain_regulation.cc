// Explanations of the codes P3, P4 and W: regulation and development.

#include "runtime/cli/explanations.h"

namespace plsc::cli {

namespace {

constexpr Explanation kRows[] = {
    {"P3001", ExampleKind::kGenotype,
     R"(max_terms and max_rules are promises of the file, here not kept: a
clause has more terms, or a symbol more rules, than they allow.
)",
     R"(plsc 1
alphabet plasticoding 1
sense hot: bool
max_rules 1
rule B -> if hot = True then { T(0.5) }
rule B -> if hot = False then { T(0.1) }
)",
     R"(plsc 1
alphabet plasticoding 1
sense hot: bool
max_rules 2
rule B -> if hot = True then { T(0.5) }
rule B -> if hot = False then { T(0.1) }
)"},
    {"P3002", ExampleKind::kCommand,
     R"(A genotype has at most 65534 rules and 1000 states; a state has at most
1000 values, an alphabet at most 1000 symbols, a file at most 1000
constants. No robot comes near; a file that does was written by a
program gone wrong.
)",
     R"(plsc check crowded.pls
)",
     R"(plsc check robot.pls
)"},
    {"P4001", ExampleKind::kDevelop,
     R"(Each rewriting replaces every symbol that has an active rule, and so the
string grows exponentially with 'iterations'. Beyond about a million
symbols development is given up. Lower 'iterations', or let rules write
fewer symbols that have rules themselves.
)",
     R"(plsc 1
alphabet plasticoding 1
iterations 30
rule C -> { C B }
rule B -> { B B }
)",
     R"(plsc 1
alphabet plasticoding 1
iterations 3
rule C -> { C B }
rule B -> { B B }
)"},
    {"W3002", ExampleKind::kGenotype,
     R"(The clause has the same truth value in every environment. A rule that is
always active is clearer without a clause; one that is never active does
nothing.
)",
     R"(plsc 1
alphabet plasticoding 1
sense hot: bool
rule B -> if hot = True and hot = False then { T(0.5) }
)",
     R"(plsc 1
alphabet plasticoding 1
sense hot: bool
rule B -> if hot = True then { T(0.5) }
)"},
    {"W3003", ExampleKind::kLint,
     R"(A symbol has rules, but in some environment none of them is active, so
that it stays as it is there. That may be meant; often a clause is
missing.
)",
     R"(plsc 1
alphabet plasticoding 1
sense hot: bool
rule B -> if hot = True then { T(0.5) }
)",
     R"(plsc 1
alphabet plasticoding 1
sense hot: bool
rule B -> if hot = True then { T(0.5) }
rule B -> if hot = False then { T(0.1) }
)"},
};

}  // namespace

std::span<const Explanation> RegulationExplanations() {
  return kRows;
}

}  // namespace plsc::cli
