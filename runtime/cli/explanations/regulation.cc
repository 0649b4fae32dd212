// Explanations of the codes P3, P4 and W: regulation and development.

#include "runtime/cli/explanations/explanations.h"

namespace plsc::cli {

namespace {

constexpr Explanation kRegulationRows[] = {
    {Code::kOwnLimit, ExampleKind::kGenotype,
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
    {Code::kLimit, ExampleKind::kCommand,
     R"(A genotype has at most 65534 rules and 1000 states; a state has at most
1000 values, an alphabet at most 1000 symbols, a file at most 1000
constants, and an expected body at most 100 modules from the core outward.
No robot comes near; a file that does was written by a program gone wrong.
)",
     R"(plsc check crowded.pls
)",
     R"(plsc check robot.pls
)"},
    {Code::kTooLongString, ExampleKind::kDevelop,
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
    {Code::kFailedTest, ExampleKind::kTest,
     R"(A 'test' item expects another string or body than what develops. The
caret is at the first symbol or module that is otherwise, and the note
has all that developed. Arguments that the test leaves out may be any.
)",
     R"(plsc 1
alphabet plasticoding 1
iterations 1
rule C -> { C add_left T(0.5) }
test grows -> { C add_left B }
)",
     R"(plsc 1
alphabet plasticoding 1
iterations 1
rule C -> { C add_left T(0.5) }
test grows -> { C add_left T }
)"},
    {Code::kWrongAllow, ExampleKind::kGenotype,
     R"(A comment that begins with "plsc:" speaks to the compiler: "allow CODE"
or "allow-file CODE", with the code of a warning. This one asks for what
does not exist.
)",
     R"(plsc 1
# plsc: allow W9999
alphabet plasticoding 1
rule C -> { C }
)",
     R"(plsc 1
# plsc: allow W3003
alphabet plasticoding 1
rule C -> { C }
)"},
    {Code::kUnsensedState, ExampleKind::kCommand,
     R"(An environment on the command line gives a value to a state that the
genotype does not declare. The value is ignored: an environment may have
more to it than one robot senses. Often the name is misspelt.
)",
     R"(plsc regulate robot.pls --env cold=True
)",
     R"(plsc regulate robot.pls
)"},
    {Code::kConstantClause, ExampleKind::kGenotype,
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
    {Code::kNoActiveRule, ExampleKind::kLint,
     R"(A symbol has rules, but in some environment none of them is active, so
that it stays as it is there. That may be meant; often a clause is
missing.
)",
     R"(plsc 1
alphabet plasticoding 1
sense hot: bool
iterations 2
rule C -> { C add_left B move_left }
rule B -> if hot = True then { B add_front B }
)",
     R"(plsc 1
alphabet plasticoding 1
sense hot: bool
iterations 2
rule C -> { C add_left B move_left }
rule B -> if hot = True then { B add_front B }
rule B -> if hot = False then { B add_right B }
)"},
    {Code::kSeveralActiveRules, ExampleKind::kLint,
     R"(Several rules of one symbol, each with a clause, are active at once in
some environment, and their productions are joined there. That may be
meant; often the clauses were thought to exclude each other.
)",
     R"(plsc 1
alphabet plasticoding 1
sense hot: bool
sense wet: bool
iterations 1
rule C -> if hot = True then { C add_left B }
rule C -> if wet = True or hot = False then { C add_right B }
)",
     R"(plsc 1
alphabet plasticoding 1
sense hot: bool
sense wet: bool
iterations 1
rule C -> if hot = True then { C add_left B }
rule C -> if hot = False then { C add_right B }
)"},
    {Code::kUnchecked, ExampleKind::kLint,
     R"(The clauses ask about so many states that there are too many environments
to look at (more than 65,536), or the strings that develop in them are too
long together, so the lints that look at all of them were left out. The
genotype is correct.
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
    {Code::kMayGrowTooLong, ExampleKind::kLint,
     R"(In some environment the string would grow beyond its limit, so that no
robot develops there (P4001). Found by counting, without developing.
)",
     R"(plsc 1
alphabet plasticoding 1
sense hot: bool
iterations 30
rule C -> { C add_left B move_left }
rule B -> if hot = True then { B B B }
rule B -> if hot = False then { B }
)",
     R"(plsc 1
alphabet plasticoding 1
sense hot: bool
iterations 3
rule C -> { C add_left B move_left }
rule B -> if hot = True then { B add_front B move_front }
rule B -> if hot = False then { B }
)"},
    {Code::kNotExpressed, ExampleKind::kLint,
     R"(In no environment does the symbol change the robot, or the rule is used
in none: a module without a mounting command, a slot that is always
taken, a command without the node that it needs.
)",
     R"(plsc 1
alphabet plasticoding 1
iterations 1
rule C -> { C B add_left B }
)",
     R"(plsc 1
alphabet plasticoding 1
iterations 1
rule C -> { C add_left B }
)"},
    {Code::kOtherJoint, ExampleKind::kLint,
     R"(A controller command acts on the newest joint that was mounted. Where the
joint right before it is not mounted, because max_modules is reached or
its place is taken, the command changes an older joint.
)",
     R"(plsc 1
alphabet plasticoding 1
iterations 1
rule C -> {
  C add_left A1(0.5, 2, 3, 1) mutate_per(1) add_left A1(0.5, 2, 3, 1)
  # plsc: allow W4002
  mutate_per(1)
}
)",
     R"(plsc 1
alphabet plasticoding 1
iterations 1
rule C -> {
  C add_left A1(0.5, 2, 3, 1) mutate_per(1) add_right A1(0.5, 2, 3, 1)
  mutate_per(1)
}
)"},
    {Code::kReadAgain, ExampleKind::kLint,
     R"(Each rewriting puts the production of C in front once more, so that with
'iterations 2' it is read twice. Where the first reading ends on the core,
the second finds every place taken. Often 'iterations 1' is meant; a rule
that ends with a move outward is read on from there.
)",
     R"(plsc 1
alphabet plasticoding 1
iterations 2
rule C -> { C add_left B }
)",
     R"(plsc 1
alphabet plasticoding 1
iterations 2
rule C -> { C add_front B move_front }
)"},
};

}  // namespace

std::span<const Explanation> RegulationExplanations() {
  return kRegulationRows;
}

}  // namespace plsc::cli
