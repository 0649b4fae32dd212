// Explanations of the codes P20: names, numbers and types of what is declared.

#include "runtime/cli/explanations/explanations.h"

namespace plsc::cli {

namespace {

constexpr Explanation kNameRows[] = {
    {Code::kUnknownSymbol, ExampleKind::kGenotype,
     R"(The alphabet of the file has no such symbol. The names of 'plasticoding
1' are those of the paper's Table 1 and distinguish capital and small
letters; the authors' program calls some of them otherwise (its AJ1 is
A2, its AJ2 is A1).
)",
     R"(plsc 1
alphabet plasticoding 1
rule B -> { add_lef T(0.5) }
)",
     R"(plsc 1
alphabet plasticoding 1
rule B -> { add_left T(0.5) }
)"},
    {Code::kArgumentCount, ExampleKind::kGenotype,
     R"(A symbol has more or fewer arguments than the alphabet gives it
parameters.
)",
     R"(plsc 1
alphabet plasticoding 1
rule B -> { A1(0.1, 2.0, 3.0) }
)",
     R"(plsc 1
alphabet plasticoding 1
rule B -> { A1(0.1, 2.0, 3.0, 4.0) }
)"},
    {Code::kNotWhole, ExampleKind::kGenotype,
     R"(The parameter counts something, and so its argument is a whole number,
written without point and exponent, at most 2^53.
)",
     R"(plsc 1
alphabet plasticoding 1
rule B -> { move_ref_I(1.5, 2) }
)",
     R"(plsc 1
alphabet plasticoding 1
rule B -> { move_ref_I(1, 2) }
)"},
    {Code::kArgumentRange, ExampleKind::kGenotype,
     R"(An argument lies outside the range of its parameter. With --allow-range
it is a warning, for robots of other programs that kept to other ranges.
)",
     R"(plsc 1
alphabet plasticoding 1
rule B -> { T(1.5) }
)",
     R"(plsc 1
alphabet plasticoding 1
rule B -> { T(1) }
)"},
    {Code::kUnknownState, ExampleKind::kGenotype,
     R"(A clause or an environment names a state that no 'sense' item declares.
)",
     R"(plsc 1
alphabet plasticoding 1
sense hot: bool
rule B -> if hott = True then { T(0.5) }
)",
     R"(plsc 1
alphabet plasticoding 1
sense hot: bool
rule B -> if hot = True then { T(0.5) }
)"},
    {Code::kValueType, ExampleKind::kGenotype,
     R"(A state is compared with a value of another type, or by an order that it
does not have: '<' and its kin are for real states only.
)",
     R"(plsc 1
alphabet plasticoding 1
sense warmth: real in 0..50
rule B -> if warmth = True then { T(0.5) }
)",
     R"(plsc 1
alphabet plasticoding 1
sense warmth: real in 0..50
rule B -> if warmth > 30 then { T(0.5) }
)"},
    {Code::kNotReplaceable, ExampleKind::kGenotype,
     R"(Only replaceable symbols have rules. Commands, and terminals of an
alphabet of your own, stay as they are in every rewriting.
)",
     R"(plsc 1
alphabet plasticoding 1
rule add_left -> { B }
)",
     R"(plsc 1
alphabet plasticoding 1
rule B -> { add_left B }
)"},
    {Code::kMisplacedCore, ExampleKind::kGenotype,
     R"(A robot has exactly one core. Therefore each rule for C starts with C,
and C stands nowhere else.
)",
     R"(plsc 1
alphabet plasticoding 1
rule C -> { add_left B }
)",
     R"(plsc 1
alphabet plasticoding 1
rule C -> { C add_left B }
)"},
    {Code::kUnknownConstant, ExampleKind::kGenotype,
     R"(An argument or a value is a name, and no 'let' item declares it.
)",
     R"(plsc 1
alphabet plasticoding 1
let weight = 0.5
rule B -> { T(wieght) }
)",
     R"(plsc 1
alphabet plasticoding 1
let weight = 0.5
rule B -> { T(weight) }
)"},
    {Code::kUnknownAlphabet, ExampleKind::kGenotype,
     R"(The alphabet is not built in and has no body, or is built in and has
one. An alphabet of your own has a name of its own.
)",
     R"(plsc 1
alphabet plasticodng 1
)",
     R"(plsc 1
alphabet plasticoding 1
)"},
    {Code::kWrongAxiom, ExampleKind::kGenotype,
     R"(Development starts from the axiom: a symbol without parameters, and with
'plasticoding' always the core C.
)",
     R"(plsc 1
alphabet plasticoding 1
axiom B
)",
     R"(plsc 1
alphabet plasticoding 1
axiom C
)"},
    {Code::kMissingItem, ExampleKind::kGenotype,
     R"(Every file says its alphabet; one with an alphabet of its own also says
its axiom, for nobody could guess it.
)",
     R"(plsc 1
rule B -> { T(0.5) }
)",
     R"(plsc 1
alphabet plasticoding 1
rule B -> { T(0.5) }
)"},
    {Code::kRepeatedItem, ExampleKind::kGenotype,
     R"(genotype, alphabet, axiom and each setting stand once in a file.
)",
     R"(plsc 1
alphabet plasticoding 1
iterations 3
iterations 4
)",
     R"(plsc 1
alphabet plasticoding 1
iterations 3
)"},
    {Code::kWrongSetting, ExampleKind::kGenotype,
     R"(The value of a setting has the wrong type or is out of range: iterations
0..100, max_modules, max_terms and max_rules 1..1000, move_to_new True
or False.
)",
     R"(plsc 1
alphabet plasticoding 1
max_modules 0
)",
     R"(plsc 1
alphabet plasticoding 1
max_modules 15
)"},
    {Code::kWrongEnvironment, ExampleKind::kGenotype,
     R"(An environment gives every declared state exactly one value, within the
range of the state. There is no default: what a robot senses decides
what it becomes.
)",
     R"(plsc 1
alphabet plasticoding 1
sense hot: bool
environment summer { }
)",
     R"(plsc 1
alphabet plasticoding 1
sense hot: bool
environment summer { hot = True }
)"},
    {Code::kWrongState, ExampleKind::kGenotype,
     R"(A state needs at least two values, all different, or a range from less
to more. What cannot change need not be sensed.
)",
     R"(plsc 1
alphabet plasticoding 1
sense ground: { dry }
)",
     R"(plsc 1
alphabet plasticoding 1
sense ground: { dry, wet }
)"},
    {Code::kRepeatedName, ExampleKind::kGenotype,
     R"(The name is declared already in the same world: symbols, parameters of a
symbol, states, constants and environments are worlds of their own.
)",
     R"(plsc 1
alphabet plasticoding 1
let w = 0.5
let w = 0.6
)",
     R"(plsc 1
alphabet plasticoding 1
let w = 0.5
let v = 0.6
)"},
    {Code::kWrongParameters, ExampleKind::kGenotype,
     R"(A symbol of your own alphabet has at most four parameters. Their ranges
go from less to more, and those of an int have whole numbers.
)",
     R"(plsc 1
alphabet mine { replaceable X; terminal turn(a: real in 9..1) }
axiom X
)",
     R"(plsc 1
alphabet mine { replaceable X; terminal turn(a: real in 1..9) }
axiom X
)"},
    {Code::kSeveralGenotypes, ExampleKind::kGenotype,
     R"(The file holds several genotypes, and the command is about one. Say which
with its name behind a '#': plsc develop zoo.pls#snake. 'plsc check',
'fmt', 'lint', 'fix' and 'test' take the whole file.
)",
     R"(plsc 1
alphabet plasticoding 1
genotype gecko
rule C -> { C B }
genotype snake
rule C -> { C add_front B }
)",
     R"(plsc 1
alphabet plasticoding 1
genotype snake
rule C -> { C add_front B }
)"},
    {Code::kWrongTest, ExampleKind::kGenotype,
     R"(A 'test' item says in which of the file's environments it develops the
genotype, unless nothing is sensed; 'after' asks for the string after
fewer rewritings than 'iterations'.
)",
     R"(plsc 1
alphabet plasticoding 1
sense hot: bool
environment summer { hot = True }
rule C -> if hot = True then { C add_left B }
test grows -> body C { left B }
)",
     R"(plsc 1
alphabet plasticoding 1
sense hot: bool
environment summer { hot = True }
rule C -> if hot = True then { C add_left B }
test grows in summer -> body C { left B }
)"},
    {Code::kImpossibleBody, ExampleKind::kGenotype,
     R"(An expected body starts with the one core, C. In braces behind a module
stand the modules at its faces: front, left and right of C and B, back of
C, front of the joints A1 and A2, none of the sensor T.
)",
     R"(plsc 1
alphabet plasticoding 1
rule C -> { C add_left A1(0.5, 1.0, 2.0, 3.0) move_left add_front B }
test arm -> body C { left A1 { left B } }
)",
     R"(plsc 1
alphabet plasticoding 1
rule C -> { C add_left A1(0.5, 1.0, 2.0, 3.0) move_left add_front B }
test arm after 1 -> body C { left A1 { front B } }
)"},
};

}  // namespace

std::span<const Explanation> NameExplanations() {
  return kNameRows;
}

}  // namespace plsc::cli
