// Explanations of the codes P11: the text does not follow the grammar.

#include "runtime/cli/explanations/explanations.h"

namespace plsc::cli {

namespace {

constexpr Explanation kSyntaxRows[] = {
    {Code::kUnknownItem, ExampleKind::kGenotype,
     R"(Each item of a file begins with a keyword: rule, sense, let, environment
and so on. Here something else stands where an item should begin: often
a misspelt keyword, a rule without 'rule', or a '}' too many.
)",
     R"(plsc 1
alphabet plasticoding 1
rulle B -> { T(0.5) }
)",
     R"(plsc 1
alphabet plasticoding 1
rule B -> { T(0.5) }
)"},
    {Code::kMissingName, ExampleKind::kGenotype,
     R"(A name is missing, or is one of the words that the language reserves.
Names are letters, digits and '_', and do not begin with a digit.
)",
     R"(plsc 1
alphabet plasticoding 1
sense rule: bool
)",
     R"(plsc 1
alphabet plasticoding 1
sense ruled: bool
)"},
    {Code::kMissingComparison, ExampleKind::kGenotype,
     R"(A clause compares each state with a value. Also a bool state is written
with its value: 'hot = True', not 'hot'.
)",
     R"(plsc 1
alphabet plasticoding 1
sense hot: bool
rule B -> if hot then { T(0.5) }
)",
     R"(plsc 1
alphabet plasticoding 1
sense hot: bool
rule B -> if hot = True then { T(0.5) }
)"},
    {Code::kForeignNotation, ExampleKind::kGenotype,
     R"(An operator or value as other languages write it. In plsc they are '=',
'!=', '<', '<=', '>', '>=', 'and', 'or', 'True' and 'False'; there is no
'not'. 'plsc fix' replaces most of them.
)",
     R"(plsc 1
alphabet plasticoding 1
sense hot: bool
rule B -> if hot == true then { T(0.5) }
)",
     R"(plsc 1
alphabet plasticoding 1
sense hot: bool
rule B -> if hot = True then { T(0.5) }
)"},
    {Code::kMissingTerm, ExampleKind::kGenotype,
     R"(Behind 'if', 'and' and 'or' stands a term: a state, a comparison and a
value.
)",
     R"(plsc 1
alphabet plasticoding 1
sense hot: bool
rule B -> if hot = True and then { T(0.5) }
)",
     R"(plsc 1
alphabet plasticoding 1
sense hot: bool
rule B -> if hot = True then { T(0.5) }
)"},
    {Code::kMissingThen, ExampleKind::kGenotype,
     R"(A clause ends in 'then', and its terms are joined by 'and' or 'or'. A
comma or the production itself stands there instead.
)",
     R"(plsc 1
alphabet plasticoding 1
sense hot: bool
rule B -> if hot = True { T(0.5) }
)",
     R"(plsc 1
alphabet plasticoding 1
sense hot: bool
rule B -> if hot = True then { T(0.5) }
)"},
    {Code::kUnclosedBrace, ExampleKind::kGenotype,
     R"(A '{' has no '}': the next item begins, or the file ends, before it is
closed.
)",
     R"(plsc 1
alphabet plasticoding 1
rule B -> { T(0.5)
rule T -> { T(0.1) }
)",
     R"(plsc 1
alphabet plasticoding 1
rule B -> { T(0.5) }
rule T -> { T(0.1) }
)"},
    {Code::kMissingValue, ExampleKind::kGenotype,
     R"(A number or another value is missing, or something that is none stands
there. A symbol without arguments is written without parentheses.
)",
     R"(plsc 1
alphabet plasticoding 1
iterations
max_modules 15
)",
     R"(plsc 1
alphabet plasticoding 1
iterations 3
max_modules 15
)"},
    {Code::kBrokenList, ExampleKind::kGenotype,
     R"(A list in parentheses goes on with ',' and ends in ')'.
)",
     R"(plsc 1
alphabet plasticoding 1
rule B -> { T(0.5 add_left }
)",
     R"(plsc 1
alphabet plasticoding 1
rule B -> { T(0.5) add_left }
)"},
    {Code::kMalformedNumber, ExampleKind::kGenotype,
     R"(A number that is written badly: digits are needed on both sides of the
point and after the 'e' of an exponent, there is no '+' before a number
and no unit behind it.
)",
     R"(plsc 1
alphabet plasticoding 1
rule B -> { T(.5) }
)",
     R"(plsc 1
alphabet plasticoding 1
rule B -> { T(0.5) }
)"},
    {Code::kForeignNumber, ExampleKind::kGenotype,
     R"(Numbers of plsc are finite and decimal: no nan, no inf, no hexadecimal,
no separator of thousands. A robot cannot be built from a nan.
)",
     R"(plsc 1
alphabet plasticoding 1
rule B -> { T(nan) }
)",
     R"(plsc 1
alphabet plasticoding 1
rule B -> { T(0.5) }
)"},
    {Code::kBeyondDouble, ExampleKind::kGenotype,
     R"(Every number is a 64-bit floating-point number. This one is larger than
any of them, or so small that it would become zero.
)",
     R"(plsc 1
alphabet plasticoding 1
rule B -> { T(1e-400) }
)",
     R"(plsc 1
alphabet plasticoding 1
rule B -> { T(1e-300) }
)"},
    {Code::kEmptyProduction, ExampleKind::kGenotype,
     R"(A production has at least one symbol: a symbol cannot be rewritten into
nothing. To keep the symbol as it is, leave the rule out.
)",
     R"(plsc 1
alphabet plasticoding 1
rule B -> { }
)",
     R"(plsc 1
alphabet plasticoding 1
rule B -> { B }
)"},
    {Code::kParentheses, ExampleKind::kGenotype,
     R"(Clauses have no parentheses. 'and' binds tighter than 'or', so that 'a
or b and c' is 'a or (b and c)'; another order is written out, or as two
rules.
)",
     R"(plsc 1
alphabet plasticoding 1
sense hot: bool
rule B -> if (hot = True) then { T(0.5) }
)",
     R"(plsc 1
alphabet plasticoding 1
sense hot: bool
rule B -> if hot = True then { T(0.5) }
)"},
    {Code::kMissingMark, ExampleKind::kGenotype,
     R"(A mark that the item needs is missing, or another one stands in its
place: '->' and '{' of a rule, ':' and 'in' of a sense, '=' of a let,
'..' of a range.
)",
     R"(plsc 1
alphabet plasticoding 1
rule B = { T(0.5) }
)",
     R"(plsc 1
alphabet plasticoding 1
rule B -> { T(0.5) }
)"},
    {Code::kStrayInBraces, ExampleKind::kGenotype,
     R"(Something stands between braces that does not belong there. Symbols of a
production are separated by blanks, not by commas.
)",
     R"(plsc 1
alphabet plasticoding 1
rule B -> { add_left, T(0.5) }
)",
     R"(plsc 1
alphabet plasticoding 1
rule B -> { add_left T(0.5) }
)"},
    {Code::kMissingType, ExampleKind::kGenotype,
     R"(A type is missing or unknown. States are 'bool', 'real in LOW..HIGH' or
'{ NAME, NAME }'; parameters of symbols are 'real' or 'int'.
)",
     R"(plsc 1
alphabet plasticoding 1
sense hot: boolean
)",
     R"(plsc 1
alphabet plasticoding 1
sense hot: bool
)"},
    {Code::kIncompleteAlphabet, ExampleKind::kGenotype,
     R"(An alphabet is either built in and named with its version, or declared
in braces.
)",
     R"(plsc 1
alphabet plasticoding
axiom C
)",
     R"(plsc 1
alphabet plasticoding 1
axiom C
)"},
    {Code::kLookalike, ExampleKind::kGenotype,
     R"(A character that looks like one of plsc, or cannot be seen: a minus sign,
a curly quote or a no-break space that a word processor or a page has put
in place of '-', '"' or a blank, a letter of another alphabet, a zero width
space. 'plsc fix' replaces them.
)",
     R"(plsc 1
alphabet plasticoding 1
let x = −0.5
)",
     R"(plsc 1
alphabet plasticoding 1
let x = -0.5
)"},
};

}  // namespace

std::span<const Explanation> SyntaxExplanations() {
  return kSyntaxRows;
}

}  // namespace plsc::cli
