#pragma once

// The grammar of plsc 1 as PEGTL rules, and nothing else: actions.h says what
// a match builds, messages.h what a failure means, recover.h where to go on.
//
// LL(1) by construction: every item starts with its keyword, every token
// takes the gap after it, and behind a keyword all that is required is a
// must<>. So no action ever runs on a match that is given up later, and the
// place of a must<> is the whole set of what was expected.

#include <tao/pegtl.hpp>

namespace plsc::grammar {

// The vocabulary of the rules below (seq, sor, must, ...) is PEGTL's.
using namespace tao::pegtl;  // NOLINT(google-build-using-namespace)

// Rules are spelled as PEGTL spells its own.
// NOLINTBEGIN(readability-identifier-naming)
// clang-format off
struct comment : seq<one<'#'>, star<not_one<'\n'>>> {};
struct gap     : star<sor<plus<one<' ', '\t', '\r', '\n'>>, comment>> {};

template <typename... Rules> struct token : seq<Rules..., gap> {};
template <char C> struct mark : token<one<C>> {};

// Numbers. A second '.' ends one, so that `-40..60` is a range.
struct fraction_digits : plus<digit> {};
struct exponent_digits : plus<digit> {};
struct fraction   : seq<one<'.'>, not_at<one<'.'>>, must<fraction_digits>> {};
struct exponent   : seq<one<'e', 'E'>, opt<one<'+', '-'>>, must<exponent_digits>> {};
struct number_end : not_at<sor<identifier_other, seq<one<'.'>, not_at<one<'.'>>>>> {};
struct number     : seq<opt<one<'-'>>, plus<digit>, opt<fraction>, opt<exponent>, must<number_end>> {};

// Values. Their actions leave them where the rule around them takes them.
struct true_value  : TAO_PEGTL_KEYWORD("True") {};
struct false_value : TAO_PEGTL_KEYWORD("False") {};
struct name_value  : identifier {};
struct any_value   : sor<true_value, false_value, number, name_value> {};

// Productions.
struct argument_value : sor<number, name_value> {};
struct argument       : token<argument_value> {};
struct close_mark     : one<')'> {};
struct close_paren    : token<close_mark> {};
struct arguments      : seq<mark<'('>, must<argument>, star<mark<','>, must<argument>>, must<close_paren>> {};
struct symbol_name    : identifier {};
struct symbol         : seq<token<symbol_name>, opt<arguments>> {};
struct first_symbol   : symbol {};
struct open_mark      : one<'{'> {};
struct open_brace     : token<open_mark> {};
struct end_mark       : one<'}'> {};
struct production_end : token<end_mark> {};
struct production     : seq<must<open_brace>, must<first_symbol>, star<symbol>, must<production_end>> {};

// Clauses.
struct equal         : seq<one<'='>, not_at<one<'='>>> {};
struct not_equal     : string<'!', '='> {};
struct less_equal    : string<'<', '='> {};
struct greater_equal : string<'>', '='> {};
struct less          : one<'<'> {};
struct greater       : one<'>'> {};
struct comparison    : token<sor<equal, not_equal, less_equal, greater_equal, less, greater>> {};
struct state_name    : identifier {};
struct term_value    : any_value {};
struct wanted_value  : token<term_value> {};
struct term          : seq<token<state_name>, must<comparison>, must<wanted_value>> {};
struct and_word      : TAO_PEGTL_KEYWORD("and") {};
struct or_word       : TAO_PEGTL_KEYWORD("or") {};
struct connective    : token<sor<and_word, or_word>> {};
struct then_word     : token<TAO_PEGTL_KEYWORD("then")> {};
struct if_word       : token<TAO_PEGTL_KEYWORD("if")> {};
struct condition     : seq<if_word, must<term>, star<connective, must<term>>, must<then_word>> {};

// Keywords of items: one rule, so that one action notes where an item begins.
struct kw_rule        : TAO_PEGTL_KEYWORD("rule") {};
struct kw_genotype    : TAO_PEGTL_KEYWORD("genotype") {};
struct kw_alphabet    : TAO_PEGTL_KEYWORD("alphabet") {};
struct kw_sense       : TAO_PEGTL_KEYWORD("sense") {};
struct kw_let         : TAO_PEGTL_KEYWORD("let") {};
struct kw_axiom       : TAO_PEGTL_KEYWORD("axiom") {};
struct kw_environment : TAO_PEGTL_KEYWORD("environment") {};
struct kw_test        : TAO_PEGTL_KEYWORD("test") {};
struct kw_iterations  : TAO_PEGTL_KEYWORD("iterations") {};
struct kw_max_modules : TAO_PEGTL_KEYWORD("max_modules") {};
struct kw_move_to_new : TAO_PEGTL_KEYWORD("move_to_new") {};
struct kw_max_terms   : TAO_PEGTL_KEYWORD("max_terms") {};
struct kw_max_rules   : TAO_PEGTL_KEYWORD("max_rules") {};
struct item_keyword   : sor<kw_rule, kw_environment, kw_sense, kw_genotype, kw_alphabet, kw_axiom, kw_let, kw_test,
                            kw_iterations, kw_max_modules, kw_move_to_new, kw_max_terms, kw_max_rules> {};
template <typename Keyword> struct begin_item : token<Keyword> {};

struct head        : identifier {};
struct wanted_head : token<head> {};
struct arrow       : token<string<'-', '>'>> {};
struct rule_item   : seq<begin_item<kw_rule>, must<wanted_head>, must<arrow>, opt<condition>, production> {};

struct item_name     : identifier {};
struct wanted_name   : token<item_name> {};
struct genotype_name : identifier {};
struct wanted_genotype_name : token<genotype_name> {};
struct genotype_item : seq<begin_item<kw_genotype>, must<wanted_genotype_name>> {};
struct axiom_item    : seq<begin_item<kw_axiom>, must<wanted_name>> {};

struct equals_mark : mark<'='> {};
struct let_number  : token<number> {};
struct let_item    : seq<begin_item<kw_let>, must<wanted_name>, must<equals_mark>, must<let_number>> {};

struct setting_value        : any_value {};
struct wanted_setting_value : token<setting_value> {};
struct setting_key  : sor<kw_iterations, kw_max_modules, kw_move_to_new, kw_max_terms, kw_max_rules> {};
struct setting_item : seq<token<setting_key>, must<wanted_setting_value>> {};

// Types of states and parameters.
struct colon       : mark<':'> {};
struct in_word     : token<TAO_PEGTL_KEYWORD("in")> {};
struct low_bound   : number {};
struct high_bound  : number {};
struct wanted_low  : token<low_bound> {};
struct wanted_high : token<high_bound> {};
struct dots        : token<string<'.', '.'>> {};
struct bounds      : seq<must<wanted_low>, must<dots>, must<wanted_high>> {};
struct real_word   : TAO_PEGTL_KEYWORD("real") {};
struct int_word    : TAO_PEGTL_KEYWORD("int") {};
struct bool_word   : TAO_PEGTL_KEYWORD("bool") {};

struct enum_value   : identifier {};
struct wanted_enum_value : token<enum_value> {};
struct enum_open    : open_brace {};
struct enum_end     : token<one<'}'>> {};
struct enum_type    : seq<enum_open, must<wanted_enum_value>, star<mark<','>, must<wanted_enum_value>>, must<enum_end>> {};
struct real_type    : seq<token<real_word>, must<in_word>, bounds> {};
struct bool_type    : token<bool_word> {};
struct state_type   : sor<bool_type, real_type, enum_type> {};
struct sense_item   : seq<begin_item<kw_sense>, must<wanted_name>, must<colon>, must<state_type>> {};

// A file's own alphabet.
struct parameter_name   : identifier {};
struct wanted_parameter : token<parameter_name> {};
struct number_type      : token<sor<real_word, int_word>> {};
struct parameter        : seq<must<wanted_parameter>, must<colon>, must<number_type>, opt<in_word, bounds>> {};
struct parameters_end   : token<one<')'>> {};
struct parameters       : seq<mark<'('>, parameter, star<mark<','>, parameter>, must<parameters_end>> {};
struct declared_name    : identifier {};
struct wanted_declared  : token<declared_name> {};
struct declaration      : seq<must<wanted_declared>, opt<parameters>> {};
struct replaceable_word : TAO_PEGTL_KEYWORD("replaceable") {};
struct terminal_word    : TAO_PEGTL_KEYWORD("terminal") {};
struct group_word       : token<sor<replaceable_word, terminal_word>> {};
struct group            : seq<group_word, declaration, star<mark<','>, declaration>, opt<mark<';'>>> {};
struct first_group      : group {};
struct alphabet_end     : token<end_mark> {};
struct alphabet_open    : token<open_mark> {};
struct vocabulary_version : number {};
struct alphabet_body    : sor<token<vocabulary_version>,
                              seq<alphabet_open, must<first_group>, star<group>, must<alphabet_end>>> {};
struct alphabet_item    : seq<begin_item<kw_alphabet>, must<wanted_name>, must<alphabet_body>> {};

struct entry_state      : identifier {};
struct entry_value      : any_value {};
struct wanted_entry_value : token<entry_value> {};
struct entry            : seq<token<entry_state>, must<equals_mark>, must<wanted_entry_value>, opt<mark<','>>> {};
struct environment_open : token<open_mark> {};
struct environment_end  : token<end_mark> {};
struct environment_item : seq<begin_item<kw_environment>, must<wanted_name>, must<environment_open>,
                              star<entry>, must<environment_end>> {};

// Tests. A body is a tree: a module, and in braces the modules at its faces.
struct module_name   : identifier {};
struct face_name     : identifier {};
struct children_open : token<open_mark> {};
struct children_end  : token<end_mark> {};
struct children;
struct body_module   : seq<token<module_name>, opt<children>> {};
struct face          : seq<token<face_name>, must<body_module>> {};
struct children      : seq<children_open, star<face>, must<children_end>> {};
struct body_word     : token<TAO_PEGTL_KEYWORD("body")> {};
struct expected_body : seq<body_word, must<body_module>> {};
struct test_place    : identifier {};
struct wanted_place  : token<test_place> {};
struct after_word    : token<TAO_PEGTL_KEYWORD("after")> {};
struct after_number  : token<number> {};
struct after         : seq<after_word, must<after_number>> {};
struct test_item     : seq<begin_item<kw_test>, must<wanted_name>, opt<in_word, must<wanted_place>>,
                           opt<after>, must<arrow>, sor<expected_body, production>> {};

struct item : sor<rule_item, environment_item, sense_item, genotype_item, alphabet_item, axiom_item, let_item, setting_item,
                  test_item> {};

struct plsc_word      : TAO_PEGTL_KEYWORD("plsc") {};
struct wanted_plsc    : token<plsc_word> {};
struct version_number : seq<plus<digit>, not_at<sor<identifier_other, one<'.'>>>> {};
struct wanted_version : token<version_number> {};
struct version        : seq<must<wanted_plsc>, must<wanted_version>> {};
// clang-format on
// NOLINTEND(readability-identifier-naming)

}  // namespace plsc::grammar
