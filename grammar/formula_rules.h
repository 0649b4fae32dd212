#pragma once

// The grammar of formulas as PEGTL rules, and nothing else; formula.cc says
// what a match builds and what a failure means.
//
// A level of precedence is a rule, the loosest first: choice, or, and, not,
// comparison, sum, product, sign. Operators of a level are steps from left to
// right, so that an action finds its operands on top of the stack. Comparisons
// do not chain: `a < b < c` is an error and not a surprise.

#include <tao/pegtl.hpp>

namespace plsc::grammar::formula {

// The vocabulary of the rules below (seq, sor, must, ...) is PEGTL's.
using namespace tao::pegtl;  // NOLINT(google-build-using-namespace)

// Rules are spelled as PEGTL spells its own.
// NOLINTBEGIN(readability-identifier-naming)
// clang-format off
struct blanks : star<one<' ', '\t', '\r', '\n'>> {};
template <typename... Rules> struct token : seq<Rules..., blanks> {};
template <char C> struct mark : token<one<C>> {};
template <char... Cs> struct sign : token<string<Cs...>> {};

struct true_word  : TAO_PEGTL_KEYWORD("True") {};
struct false_word : TAO_PEGTL_KEYWORD("False") {};
struct and_word   : token<TAO_PEGTL_KEYWORD("and")> {};
struct or_word    : token<TAO_PEGTL_KEYWORD("or")> {};
struct not_word   : token<TAO_PEGTL_KEYWORD("not")> {};
struct reserved   : sor<true_word, false_word, and_word, or_word, not_word> {};

struct fraction_digits : plus<digit> {};
struct exponent_digits : plus<digit> {};
struct number_end : not_at<sor<identifier_other, one<'.'>>> {};
struct digits     : seq<plus<digit>, opt<one<'.'>, must<fraction_digits>>,
                        opt<one<'e', 'E'>, opt<one<'+', '-'>>, must<exponent_digits>>> {};
struct number     : seq<digits, must<number_end>> {};
struct name       : seq<not_at<reserved>, identifier> {};

struct choice;
struct open       : mark<'('> {};
struct close      : mark<')'> {};
struct call_open  : mark<'('> {};
struct call_end   : one<')'> {};
struct call_close : token<call_end> {};
struct call       : seq<token<name>, call_open, must<choice>, star<mark<','>, must<choice>>, must<call_close>> {};
struct variable   : token<name> {};
struct grouped    : seq<open, must<choice>, must<close>> {};
struct primary    : sor<token<number>, token<true_word>, token<false_word>, call, variable, grouped> {};

struct minus   : mark<'-'> {};
struct factor;
struct negated : seq<minus, must<factor>> {};
struct factor  : sor<negated, primary> {};

struct multiply_step : seq<mark<'*'>, must<factor>> {};
struct divide_step   : seq<mark<'/'>, must<factor>> {};
struct product       : seq<factor, star<sor<multiply_step, divide_step>>> {};

struct add_step      : seq<mark<'+'>, must<product>> {};
struct subtract_step : seq<mark<'-'>, must<product>> {};
struct sum           : seq<product, star<sor<add_step, subtract_step>>> {};

struct less_equal_step    : seq<sign<'<', '='>, must<sum>> {};
struct greater_equal_step : seq<sign<'>', '='>, must<sum>> {};
struct less_step          : seq<mark<'<'>, must<sum>> {};
struct greater_step       : seq<mark<'>'>, must<sum>> {};
struct equal_step         : seq<sign<'=', '='>, must<sum>> {};
struct not_equal_step     : seq<sign<'!', '='>, must<sum>> {};
struct comparison : seq<sum, opt<sor<less_equal_step, greater_equal_step, less_step, greater_step,
                                     equal_step, not_equal_step>>> {};

struct not_mark    : not_word {};
struct condition;
struct denied      : seq<not_mark, must<condition>> {};
struct condition   : sor<denied, comparison> {};
struct and_step    : seq<and_word, must<condition>> {};
struct conjunction : seq<condition, star<and_step>> {};
struct or_step     : seq<or_word, must<conjunction>> {};
struct disjunction : seq<conjunction, star<or_step>> {};

struct question    : mark<'?'> {};
struct colon       : mark<':'> {};
struct choice_step : seq<question, must<choice>, must<colon>, must<choice>> {};
struct choice      : seq<disjunction, opt<choice_step>> {};

struct end   : eof {};
struct whole : seq<blanks, must<choice>, must<end>> {};
// clang-format on
// NOLINTEND(readability-identifier-naming)

}  // namespace plsc::grammar::formula
