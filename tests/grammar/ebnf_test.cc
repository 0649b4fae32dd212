#include "grammar/ebnf.h"

#include <catch2/catch.hpp>

#include "grammar/ebnf_of.h"

// Rules as the grammar has them: named in its namespace.
namespace plsc::grammar {
// NOLINTBEGIN(readability-identifier-naming)
// clang-format off
struct t_word    : token<TAO_PEGTL_KEYWORD("plus")> {};
struct t_either  : sor<one<'+', '-'>, t_word> {};
struct t_name    : identifier {};
struct t_label   : token<identifier> {};
struct t_sum     : seq<token<t_name>, star<t_either, must<t_label>>> {};
struct t_same    : t_sum {};
struct t_choice  : seq<mark<'('>, opt<t_sum>, must<mark<')'>>, not_at<one<'='>>> {};
struct t_end     : not_at<identifier_other> {};
struct t_lost    : until<one<';'>> {};
struct t_try     : sor<try_catch<must<t_choice>>, t_lost> {};
struct t_text    : seq<one<'"'>, until<one<'"'>, not_one<'\n'>>, t_end> {};
struct t_nest    : seq<one<'<'>, opt<t_nest>, one<'>'>> {};
struct t_all     : seq<opt<utf8::bom>, plus<t_try>, t_text, t_nest, if_must<t_word, t_same>, range<'0', '7'>, eof> {};

// A rule whose match() is written by hand, for speed.
struct t_quick {
  using rule_t = t_quick;
  using subs_t = empty_list;
};
struct t_by_hand : seq<token<t_quick>, t_quick> {};
// clang-format on
// NOLINTEND(readability-identifier-naming)
}  // namespace plsc::grammar

namespace plsc::testing {

template <>
struct ReadsLike<grammar::t_quick> {
  using type = grammar::t_either;
};

namespace {

constexpr const char* kExpected =
    R"ebnf(t_all    = [ ? U+FEFF ? ] t_choice { t_choice } t_text t_nest "plus" t_sum
           "0" ... "7" ;
t_choice = "(" [ t_sum ] ")" ;
t_sum    = name { t_either name } ;
t_either = "+" | "-" | "plus" ;
t_text   = '"' { ? any character but U+000A ? } '"' ;
t_nest   = "<" [ t_nest ] ">" ;
name     = ( "a" ... "z" | "A" ... "Z" | "_" ) { "a" ... "z" | "A" ... "Z"
           | "0" ... "9" | "_" } ;
)ebnf";

TEST_CASE("A grammar's types print as EBNF", "[ebnf]") {
  EbnfGrammar grammar;
  EbnfWalk walk(grammar);
  grammar.lexical = {walk.Add<tao::pegtl::identifier>("name")};
  grammar.names = {{"name", "name"}};
  grammar.start = walk.Add<grammar::t_all>("t_all");
  // Not shown: gaps, looking ahead, t_lost behind an error, t_end. t_label is
  // a name, t_word a terminal, t_same is t_sum. t_nest ends although it
  // contains itself.
  CHECK(PrintEbnf(grammar) == kExpected);
}

TEST_CASE("A rule matched by hand prints as what it reads like", "[ebnf]") {
  EbnfGrammar grammar;
  grammar.start = EbnfWalk(grammar).Add<grammar::t_by_hand>("t_by_hand");
  CHECK(PrintEbnf(grammar) ==
        "t_by_hand = t_quick t_quick ;\n"
        "t_quick   = \"+\" | \"-\" | \"plus\" ;\n");
}

TEST_CASE("A choice within a sequence stands in parentheses", "[ebnf]") {
  using EbnfKind = Ebnf::Kind;
  const Ebnf a{EbnfKind::kTerminal, "\"a\"", {}};
  const Ebnf b{EbnfKind::kTerminal, "\"b\"", {}};
  const Ebnf choice{EbnfKind::kChoice, "", {a, b}};
  struct {
    const char* why;
    Ebnf body;
    const char* text;
  } const cases[] = {
      {"alone it does not", choice, "s = \"a\" | \"b\" ;\n"},
      {"of one part it is none",
       {EbnfKind::kSequence, "", {{EbnfKind::kChoice, "", {a, {}}}, b}},
       "s = \"a\" \"b\" ;\n"},
      {"in a sequence",
       {EbnfKind::kSequence, "", {choice, b}},
       "s = ( \"a\" | \"b\" ) \"b\" ;\n"},
      {"braces are enough",
       {EbnfKind::kRepeat, "", {choice}},
       "s = { \"a\" | \"b\" } ;\n"},
      {"choices of choices are one",
       {EbnfKind::kChoice, "", {choice, b}},
       "s = \"a\" | \"b\" | \"b\" ;\n"},
      {"nothing repeated is nothing",
       {EbnfKind::kSequence, "", {{EbnfKind::kRepeat, "", {Ebnf{}}}, a}},
       "s = \"a\" ;\n"},
  };
  for (const auto& c : cases) {
    INFO(c.why);
    CHECK(PrintEbnf({"s", {}, {}, {{"s", {{"s"}, c.body}}}}) == c.text);
  }
}

TEST_CASE("A rule of several names takes the given, else the shortest",
          "[ebnf]") {
  const Ebnf body{Ebnf::Kind::kTerminal, "\"x\"", {}};
  EbnfGrammar grammar{
      "k", {}, {}, {{"k", {{"long_name", "name", "other"}, body}}}};
  CHECK(PrintEbnf(grammar) == "name = \"x\" ;\n");
  grammar.names = {{"other", "chosen"}};
  CHECK(PrintEbnf(grammar) == "chosen = \"x\" ;\n");
}

}  // namespace
}  // namespace plsc::testing
